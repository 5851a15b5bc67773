"""A display to draw on: VTK needs one."""

import contextlib
import ctypes
import os
import secrets
import shutil
import signal
import struct
import subprocess
import tempfile
from collections.abc import Iterator

OTHER = "PERCUSS_DISPLAY"  # a display that is used in place of a virtual one, such as :7
NUMBERS = range(99, 299)
SCREEN = ["-screen", "0", "64x64x24", "-nolisten", "tcp"]


class NoDisplay(RuntimeError):
    """There is no display, and no server to make one."""


@contextlib.contextmanager
def open_display() -> Iterator[str]:
    """Makes DISPLAY a virtual display, where there is Xvfb: it gives the same pictures on every machine.
    Else it is that of the user."""
    server, other = shutil.which("Xvfb"), os.environ.get(OTHER)
    if other or not server:
        name = other or os.environ.get("DISPLAY")
        if not name:
            raise NoDisplay("there is no display, and no Xvfb to make one: run scripts/install_dependencies --render")
        os.environ["DISPLAY"] = name
        yield name
        return
    with tempfile.TemporaryDirectory(prefix="percuss_display_") as folder:
        key = _write_key(folder)
        process, name = _start(server, key)
        os.environ.update(DISPLAY=name, XAUTHORITY=key)
        try:
            yield name
        finally:
            process.terminate()
            process.wait()


def _start(server: str, key: str) -> tuple[subprocess.Popen[bytes], str]:
    """The server with the first free number. Low numbers belong to screens, which other programs look for."""
    for number in NUMBERS:
        if any(map(os.path.exists, (f"/tmp/.X{number}-lock", f"/tmp/.X11-unix/X{number}"))):
            continue
        reading, writing = os.pipe()
        with open(reading, encoding="ascii") as ready:
            process = subprocess.Popen([server, f":{number}", "-displayfd", str(writing), "-auth", key, *SCREEN],
                                       pass_fds=(writing,), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL, preexec_fn=_end_with_parent)
            os.close(writing)
            if ready.readline().strip():
                return process, f":{number}"
        process.wait()  # another server has taken the number
    raise NoDisplay(f"{server} does not start: try it in a shell")


def _end_with_parent() -> None:
    """The server ends with the program that draws, even where that is killed (PR_SET_PDEATHSIG of Linux)."""
    signal.pthread_sigmask(signal.SIG_SETMASK, ())
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)


def _write_key(folder: str) -> str:
    """A key without which no other user can draw on the display:
    an entry of Xlib's file of keys for any host and any number."""
    words = (b"", b"", b"MIT-MAGIC-COOKIE-1", secrets.token_bytes(16))
    path = os.path.join(folder, "key")
    with open(path, "wb") as file:
        file.write(struct.pack(">H", 0xFFFF) + b"".join(struct.pack(">H", len(word)) + word for word in words))
    return path
