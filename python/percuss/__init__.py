"""Readers of the results of percuss, without a build: docs/results.md.

    import percuss
    run = percuss.read("out/ball")
    run.history["kinetic"], run.history.unit("kinetic")
    run.fields.values("von_mises", -1)

Nothing is read before it is asked for. The history needs NumPy, the fields h5py as well; the rest Python 3.10 alone.
`python3 -m percuss` lists the tools."""

from typing import Any

from .errors import NotResults
from .results import units
from .results.run import Run, read

__all__ = ["Run", "NotResults", "read", "filter_cfc", "resample", "units"]


def __getattr__(name: str) -> Any:
    if name in ("filter_cfc", "resample"):
        from .results import filters

        return getattr(filters, name)
    raise AttributeError(f"module 'percuss' has no attribute '{name}'")
