"""Rigid walls: each a plate in the plane of the wall, under and a little around the bodies."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .colors import rgb

MARGIN = 0.08  # of the plate around the bodies, as a share of the size of the scene
GAP = 5e-4     # by which the plate lies behind the wall, likewise: faces that lie on the wall are seen
FRONT, EDGE = rgb("#dfe3e6"), rgb("#9aa1a8")
SEEN_FROM_BEHIND = 0.25  # opacity then: what lives in front of the wall is seen through it


def span_wall(point, normal, points):
    """Four corners of a plate in the wall's plane that lies under all points [n][3], as seen along the normal."""
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    first = np.eye(3)[np.argmin(np.abs(normal))]
    first = first - (first @ normal) * normal
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    along, across = points @ first, points @ second
    a = along.min() - MARGIN * size, along.max() + MARGIN * size
    b = across.min() - MARGIN * size, across.max() + MARGIN * size
    height = point @ normal - GAP * size
    return np.array([height * normal + u * first + v * second for u, v in
                     ((a[0], b[0]), (a[1], b[0]), (a[1], b[1]), (a[0], b[1]))])


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
