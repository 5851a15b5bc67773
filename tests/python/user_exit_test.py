"""Ways by which code of users ends the program, and numbers that no run can go on with: user_exit_test.py ROOT PERCUSS [MPIEXEC ...].

Exit code 77 (skipped) without a compiler of C or without NumPy.
"""

import csv
import os
import shutil
import subprocess
import unittest

from given import MPIEXEC
from law_runs import LawTest, need, write_cube

need("cc")

# Elastic; BODY is what it does besides. It has room for two state variables a point.
LAW = """
#define _GNU_SOURCE
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
TOP
void vumat_(const int* block, const int* ndir, const int* nshr, const int* states, const int* fields, const int* count,
            const int* info, const double* step_time, const double* total_time, const double* dt, const char* name,
            const double* places, const double* length, const double* props, const double* density, const double* strain,
            const double* spin, const double* t0, const double* u0, const double* f0, const double* q0, const double* stress,
            const double* state, const double* e0, const double* d0, const double* t1, const double* u1, const double* f1,
            const double* q1, double* out, double* next, double* e1, double* d1) {
  const int n = block[0];
  for (int i = 0; i < n; ++i) {
    const double trace = strain[i] + strain[n + i] + strain[2 * n + i];
    for (int k = 0; k < 6; ++k) out[k * n + i] = stress[k * n + i] + 2e9 * strain[k * n + i] + (k < 3 ? 1e9 * trace : 0);
  }
  if (*total_time WHEN) { BODY }
}
"""
FREE = ["{nodes: cube/x_min, velocity: {x: 1}}"]
NONE = ""


class UserExit(LawTest):
    def setUp(self):
        super().setUp()
        self.deck = write_cube("model: user, density: 1600, vumat: law.so, state_variables: 2", 2e-3, FREE, cells=4,
                               more="").replace("output: {", "output: {checkpoint: {every: 2.0e-4}, ")

    def compile(self, body, top=NONE, when="> 6e-4", compiler="cc"):
        text = LAW.replace("TOP", top).replace("BODY", body).replace("WHEN", when)
        if compiler == "c++":
            text = text.replace("void vumat_(", 'extern "C" void vumat_(')
        self.compile_file(self.write("law.cpp" if compiler == "c++" else "law.c", text), "-O1", compiler=compiler)

    def check_end(self, words, launcher=(), out="out"):
        done = self.call(self.deck, "--quiet", "--force", "--out", out, launcher=launcher)
        self.assertEqual((done.returncode, done.stderr.count("law.so has ended the run"), words in done.stderr), (3, 1, True), done.stderr)
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertTrue(all(len(row) == len(rows[0]) for row in rows))
        self.assertFalse([name for name in os.listdir(os.path.join(self.folder, out)) if "lock" in name])
        return done

    WAYS = {
        "exit(0);": "by exit", "exit(7);": "by exit", "quick_exit(0);": "by exit", "_exit(0);": "by _exit", "_Exit(0);": "by _Exit",
        "abort();": "by abort", "pthread_exit(NULL);": "by pthread_exit", "raise(SIGILL);": "SIGILL", "raise(SIGFPE);": "SIGFPE",
        "*(volatile int*)8 = 1;": "SIGSEGV", "if (n > deep(1 << 20)) e1[0] = 1;": "SIGSEGV",
    }

    def test_each_way_out_ends_the_run_with_the_name_of_the_library(self):
        top = "static int deep(int n) { volatile char room[4096]; room[n % 4096] = 1; return n > 0 ? deep(n - 1) + room[(n + 1) % 4096] : 0; }"
        for statement, words in self.WAYS.items():
            with self.subTest(statement):
                self.compile(statement, top)
                self.check_end(words)

    def test_all_ranks_end_with_one_message(self):
        if not MPIEXEC:
            self.skipTest("no mpiexec")
        for statement, words in (("exit(0);", "by exit"), ("_exit(0);", "by _exit"), ("abort();", "by abort")):
            with self.subTest(statement):
                self.compile(statement, when="> 6e-4 && block[4] == 1")
                self.check_end(words, launcher=[*MPIEXEC, "2"])

    def test_an_exception_is_named(self):
        need("c++")
        self.compile("throw 1;", compiler="c++")
        self.check_end("by abort, or an exception")

    def test_a_stop_of_fortran_is_named(self):
        if not shutil.which("gfortran"):
            self.skipTest("no gfortran")
        for statement in ("stop", "stop 'bad state'", "error stop 3", "call exit(0)"):
            with self.subTest(statement):
                self.compile("leave_();", "void leave_(void);")
                self.write("leave.f", f"      subroutine leave\n      {statement}\n      end\n")
                subprocess.run(["gfortran", "-shared", "-fPIC", "-o", "law.so", "law.c", "leave.f"], cwd=self.folder, check=True)
                done = self.check_end("by exit")
                self.assertEqual("bad state" in done.stderr, "bad state" in statement, done.stderr)

    def test_check_and_the_first_answers_are_no_way_out(self):
        for statement in ("exit(0);", "_exit(0);"):
            self.compile(statement, when=">= 0")
            done = self.call(self.deck, command="check")
            self.assertEqual((done.returncode, "law.so has ended" in done.stderr), (3, True), done.stderr)
        self.compile("", top="__attribute__((constructor)) static void begin(void) { exit(0); }")
        done = self.call(self.deck, command="check")
        self.assertEqual((done.returncode, "law.so has ended" in done.stderr), (3, True), done.stderr)

    def test_results_before_the_end_are_whole(self):
        self.compile("exit(0);")
        self.check_end("by exit")
        self.compile("")
        done = self.call(self.deck, "--quiet", "--restart", "out/checkpoint.h5", "--force", "--out", "on")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_process_of_the_code_may_end(self):
        self.compile("if (*total_time < 7e-4) { const pid_t other = fork(); if (other == 0) _exit(5); int status; waitpid(other, &status, 0); }")
        done = self.call(self.deck, "--quiet", "--force", "--out", "out", "--set", "time.max_steps=8")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stderr)

    def test_a_state_variable_that_is_no_number_is_told_in_its_step(self):
        for value in ("NAN", "INFINITY", "-INFINITY"):
            with self.subTest(value):
                self.compile(f"for (int i = 0; i < n; ++i) if (block[4 + i] == 11) next[n + i] = {value};")
                done = self.call(self.deck, "--quiet", "--force", "--out", "out")
                word = value.lower().replace("inity", "")
                self.assertEqual((done.returncode, "element 11 " in done.stderr, f"state variable 2 that is {word}" in done.stderr, "law.so" in done.stderr),
                                 (3, True, True, True), done.stderr)
                self.assertIn("in step 6 at t = 0.000705882", done.stderr)  # the first that ends behind 6e-4
                self.compile("")
                again = self.call(self.deck, "--quiet", "--restart", "out/checkpoint.h5", "--force", "--out", "on")
                self.assertEqual(again.returncode, 0, again.stderr)

    def test_other_numbers_that_are_none_end_the_run(self):
        for place in ("e1[0]", "d1[0]"):
            self.compile(f"{place} = NAN;")
            done = self.call(self.deck, "--quiet", "--force", "--out", "out")
            self.assertEqual((done.returncode, "law.so" in done.stderr), (3, True), done.stderr)

    def test_a_library_that_is_cut_off_is_refused(self):
        self.compile("")
        with open(os.path.join(self.folder, "law.so"), "rb") as file:
            whole = file.read()
        for share in (0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999):
            with self.subTest(share):
                with open(os.path.join(self.folder, "law.so"), "wb") as file:
                    file.write(whole[: int(share * len(whole))])
                done = self.call(self.deck, command="check")
                self.assertEqual((done.returncode, "law.so" in done.stderr, "cut off" in done.stderr), (2, True, True), done.stderr)


if __name__ == "__main__":
    unittest.main()
