"""Films of pictures, by ffmpeg."""

import os
import shutil
import subprocess
import tempfile
from typing import Any

import numpy as np

from percuss.files import make_mark

from .selection import BadChoice

CODECS = {"mp4": ["-c:v", "libx264", "-crf", "18", "-preset", "medium", "-movflags", "+faststart"],
          "webm": ["-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0"]}
REST = 1.2  # seconds on the last picture


def check_ffmpeg() -> None:
    if not shutil.which("ffmpeg"):
        raise BadChoice("there is no ffmpeg, which makes mp4 and webm: install it "
                        "(Debian: ffmpeg), or leave --video out")


def encode_video(images: list[Any], fps: float, kind: str) -> bytes:
    """Bytes of the film. images: of one size; odd sizes lose a line."""
    width, height = (size - size % 2 for size in images[0].size)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, f"film.{kind}")
        command = ["ffmpeg", "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r",
                   f"{fps:g}", "-i", "-", *CODECS[kind], "-pix_fmt", "yuv420p", "-metadata",
                   f"comment={make_mark('render')}", path]
        pictures = [np.ascontiguousarray(np.asarray(image.convert("RGB"))[:height, :width]).tobytes()
                    for image in images]
        pictures += pictures[-1:] * round(REST * fps)
        done = subprocess.run(command, input=b"".join(pictures), capture_output=True, check=False)
        if done.returncode != 0:
            raise BadChoice(f"ffmpeg cannot make the {kind} ({done.stderr.decode('utf-8', 'replace').strip()[-200:]})")
        with open(path, "rb") as file:
            return file.read()
