"""The type of arrays in annotations: their kind of number and their shape stand in words beside them."""

from typing import Any

import numpy.typing as npt

Array = npt.NDArray[Any]
