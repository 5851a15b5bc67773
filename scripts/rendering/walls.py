"""Rigid walls as actors of VTK."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .colors import rgb

FRONT, EDGE = rgb("#dfe3e6"), rgb("#9aa1a8")
SEEN_FROM_BEHIND = 0.25  # opacity then: what lives in front of the wall is seen through it


class WallPlate:
    """A plate that may move from frame to frame; `actor` draws it."""

    def __init__(self, line_width):
        self._points, cells, self._mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
        cells.InsertNextCell(4)
        for corner in range(4):
            cells.InsertCellPoint(corner)
        self._mesh.SetPoints(self._points)
        self._mesh.SetPolys(cells)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._mesh)
        mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        _color(self.actor.GetProperty(), line_width)

    def place(self, corners, seen_from_behind):
        """corners: [4][3]."""
        self._points.SetData(numpy_to_vtk(np.ascontiguousarray(corners), deep=1))
        self._mesh.Modified()
        self.actor.GetProperty().SetOpacity(SEEN_FROM_BEHIND if seen_from_behind else 1)


def _color(look, line_width):
    look.SetColor(*FRONT)
    look.SetAmbient(0.45)
    look.SetDiffuse(0.6)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(*EDGE)
    look.SetLineWidth(line_width)
