"""Rigid walls as actors of VTK."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .colors import rgb

FRONT, EDGE = rgb("#dfe3e6"), rgb("#9aa1a8")
SEEN_FROM_BEHIND = 0.25  # opacity then: what lives in front of the wall is seen through it


def make_wall_actor(corners, seen_from_behind, line_width):
    points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(corners), deep=1))
    cells.InsertNextCell(4)
    for corner in range(4):
        cells.InsertCellPoint(corner)
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*FRONT)
    look.SetAmbient(0.45)
    look.SetDiffuse(0.6)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(*EDGE)
    look.SetLineWidth(line_width)
    if seen_from_behind:
        look.SetOpacity(SEEN_FROM_BEHIND)
    return actor
