"""Rigid walls as actors of VTK."""

from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from percuss.results.arrays import Array

from .colors import rgb

FRONT, EDGE = rgb("#dfe3e6"), rgb("#9aa1a8")
SEEN_FROM_BEHIND = 0.25  # opacity then: what lives in front of the wall is seen through it


class WallPlates:
    """The plates of a wall, which may move from frame to frame; `actor` draws them.
    The edges of a wall of one plate are drawn."""

    def __init__(self, line_width: float) -> None:
        self._points, self._cells, self._mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
        self._mesh.SetPoints(self._points)
        self._mesh.SetPolys(self._cells)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._mesh)
        mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        _color(self.actor.GetProperty(), line_width)

    def place(self, plates: Array | None, seen_from_behind: bool) -> None:
        """plates: [k][4][3], as many at every call; None: they are not drawn."""
        self.actor.SetVisibility(plates is not None)
        if plates is None:
            return
        self.actor.GetProperty().SetEdgeVisibility(len(plates) == 1)
        corners = np.ascontiguousarray(np.reshape(plates, (-1, 3)))
        self._points.SetData(numpy_to_vtk(corners, deep=1))
        for first in range(0, 0 if self._cells.GetNumberOfCells() else len(corners), 4):
            self._cells.InsertNextCell(4)
            for corner in range(first, first + 4):
                self._cells.InsertCellPoint(corner)
        self._mesh.Modified()
        self.actor.GetProperty().SetOpacity(SEEN_FROM_BEHIND if seen_from_behind else 1)


def _color(look: Any, line_width: float) -> None:
    look.SetColor(*FRONT)
    look.SetAmbient(0.45)
    look.SetDiffuse(0.6)
    look.SetEdgeColor(*EDGE)
    look.SetLineWidth(line_width)
