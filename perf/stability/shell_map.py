"""The step bound of random shells over the step of their largest eigenvalue, by families of shapes."""
import json
import subprocess


def measure_shells(tool, trials, report):
    lines = subprocess.run([str(tool), str(trials)], check=True, capture_output=True, text=True).stdout.splitlines()
    rows = [json.loads(line) for line in lines]
    worst = max(rows, key=lambda row: row["largest"])
    report(f"shells, {sum(row['count'] for row in rows)} elements: largest bound / true {worst['largest']:.6f} "
           f"({worst['family']})")
    return rows
