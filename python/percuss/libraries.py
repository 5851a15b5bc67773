"""Python libraries that tools need: whether they are there, and what to do where they are missing."""

import importlib
import os
from collections.abc import Iterable

NAMES = {  # name for the user, package of Debian
    "numpy": ("NumPy", "python3-numpy"),
    "h5py": ("h5py", "python3-h5py"),
    "matplotlib": ("Matplotlib", "python3-matplotlib"),
    "scipy": ("SciPy", "python3-scipy"),
    "yaml": ("PyYAML", "python3-yaml"),
    "PIL.Image": ("Pillow", "python3-pil"),
    "vtkmodules.vtkRenderingOpenGL2": ("VTK 9", "python3-vtk9"),
}


class MissingLibrary(ImportError):
    """A library that a tool cannot do without is not there. The text says what to do."""


def require(what: str, libraries: Iterable[str], option: str = "--report") -> None:
    """Loads the libraries that something needs.
    what: 'plots need', for the message; option: of scripts/install_dependencies."""
    libraries = list(libraries)
    try:
        for library in libraries:
            importlib.import_module(library)
    except ImportError as error:
        names = _join([NAMES[library][0] for library in libraries])
        raise MissingLibrary(f"{error} ({what} Python 3 with {names}): "
                             f"{describe_install(libraries, option)}") from error


def describe_install(libraries: Iterable[str], option: str = "--report") -> str:
    """What to do where libraries are missing: only a checkout has a script for it."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    if os.path.exists(os.path.join(root, "scripts/install_dependencies")):
        return f"run scripts/install_dependencies {option}".rstrip()
    return f"install {_join([NAMES[library][1] for library in libraries])} (names of Debian)"


def _join(words: list[str]) -> str:
    return " and ".join([", ".join(words[:-1])] * (len(words) > 1) + words[-1:])
