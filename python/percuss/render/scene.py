"""One picture: the surface of a frame, lit and shaded, with colour bar, title and time."""

import os
import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np
import vtkmodules.vtkRenderingCore as vtk
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws the rest)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from percuss.results.arrays import Array

from .camera import narrow_view
from .colors import rgb
from .mirrors import Planes, reflect
from .skin import Skin
from .walls import WallPlates

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
VTK_FONT_FILE = 4  # a constant of VTK that its Python modules do not name
INK = rgb("#2b2f36")
VEIL = 0.7  # opacity of the white behind texts
MARK_TO_THE_LEFT = 0.5  # share of the width
SMOOTH_BELOW = 35.0  # degrees between faces: round bodies look round, edges of blocks stay sharp


def make_cells(offsets: Array, corners: Array) -> Any:
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=1), numpy_to_vtkIdTypeArray(corners.astype(np.int64), deep=1))
    return cells


class Surface:
    """The lines and polygons of a skin, whose points move from frame to frame."""

    def __init__(self, skin: Skin) -> None:
        self.points = vtkPoints()
        self.mesh = vtkPolyData()
        self.mesh.SetPoints(self.points)
        self.choose(skin)

    def choose(self, skin: Skin) -> None:
        """Another skin of the same mesh; it has neither places nor colours until it is given some."""
        self.skin = skin
        behind = int(skin.offsets[skin.lines])
        self.mesh.SetLines(make_cells(skin.offsets[: skin.lines + 1], skin.corners[:behind]))
        self.mesh.SetPolys(make_cells(skin.offsets[skin.lines :] - behind, skin.corners[behind:]))

    def move(self, positions: Array) -> None:
        self.points.SetData(numpy_to_vtk(np.ascontiguousarray(self.skin.at_points(positions)), deep=1))
        self.mesh.Modified()

    def color(self, place: str, values: Array) -> None:
        """values: one number a point or a polygon of the skin."""
        data = self.mesh.GetPointData() if place == "node" else self.mesh.GetCellData()
        data.SetScalars(numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=1))


class Scene:
    def __init__(self, surface: Surface, lut: Any, size: tuple[int, int], supersampling: int, edges: bool) -> None:
        self.width, self.height = size
        self.scale = supersampling
        self._walls, self._mark = list[WallPlates](), list[Any]()
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)  # pictures are drawn larger and reduced, which smooths text and shading as well
        self.window.SetSize(self.width * self.scale, self.height * self.scale)
        self.window.AddRenderer(self.renderer)
        self._add_surface(surface, lut, edges)
        self._add_lights()

    def _add_surface(self, surface: Surface, lut: Any, edges: bool) -> None:
        self._normals = vtkPolyDataNormals()
        self._normals.SetInputData(surface.mesh)
        self._normals.SetFeatureAngle(SMOOTH_BELOW)
        self._normals.ConsistencyOff()
        self._lut = lut
        self.mapper = self._make_mapper(self._normals)
        actor = vtk.vtkActor()
        actor.SetMapper(self.mapper)
        look = actor.GetProperty()
        look.SetInterpolationToPhong()
        look.SetAmbient(0.30)
        look.SetDiffuse(0.82)
        look.SetSpecular(0.08)
        look.SetSpecularPower(20)
        look.SetLineWidth(1.8 * self.scale)  # of beams
        if edges:
            look.EdgeVisibilityOn()
            look.SetEdgeColor(*rgb("#4a4f57"))
            look.SetLineWidth(0.35 * self.scale)
        self.renderer.AddActor(actor)
        self._surface = actor

    def _make_mapper(self, source: Any) -> Any:
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.SetLookupTable(self._lut)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
        return mapper

    def add_copies(self, copies: list[Planes]) -> None:
        """copies: for each the planes (axis, value) that mirror it. An odd number of mirrors turns faces inside out,
        which would be lit from within: their corners are taken in the other order."""
        turned = vtkReverseSense()
        turned.SetInputConnection(self._normals.GetOutputPort())
        turned_mapper = self._make_mapper(turned)
        for planes in copies:
            actor = vtk.vtkActor()
            actor.ShallowCopy(self._surface)
            if len(planes) % 2:
                actor.SetMapper(turned_mapper)
            scale, place = [1.0, 1.0, 1.0], [0.0, 0.0, 0.0]
            for axis, value in planes:
                scale[axis], place[axis] = -1, 2 * value
            actor.SetScale(*scale)
            actor.SetPosition(*place)
            self.renderer.AddActor(actor)

    def _add_lights(self) -> None:
        """Daylight: much from everywhere (ambient), a warm key light from above the camera's left,
        a cool fill from its right."""
        self.renderer.AutomaticLightCreationOff()
        for place, color, strength in (((-0.5, 0.95, 0.75), "#fff4e4", 0.50), ((0.9, 0.15, 0.75), "#eef3ff", 0.54),
                                       ((0.0, 0.0, 1.0), "#ffffff", 0.20)):
            light = vtk.vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(*place)
            light.SetFocalPoint(0, 0, 0)
            light.SetColor(*rgb(color))
            light.SetIntensity(strength)
            self.renderer.AddLight(light)

    def shade(self, size_of_scene: float, cell_size: float) -> None:
        """Dims hollows and contacts, as scattered daylight does. Lengths in the units of the mesh."""
        self.renderer.UseSSAOOn()
        self.renderer.SetSSAORadius(0.05 * size_of_scene)
        self.renderer.SetSSAOBias(0.12 * cell_size)
        self.renderer.SetSSAOKernelSize(32)
        self.renderer.SSAOBlurOn()

    def place_walls(self, walls: list[tuple[Array | None, bool]]) -> None:
        """walls: [(plates [k][4][3], whether it is seen from behind)], as many at every call; where they are from now
        on. Plates of None are not drawn."""
        for _ in walls[len(self._walls) :]:
            self._walls.append(WallPlates(0.6 * self.scale))
            self.renderer.AddActor(self._walls[-1].actor)
        for wall, place in zip(self._walls, walls):
            wall.place(*place)

    def aim(self, position: Array, target: Array, up: Array, zoom: float, sample: Array) -> None:
        """sample: points [n][3] of all that is drawn."""
        camera = self.renderer.GetActiveCamera()
        camera.SetViewAngle(narrow_view(zoom))
        camera.SetPosition(*position)
        camera.SetFocalPoint(*target)
        camera.SetViewUp(*up)
        self._stand = np.asarray(position), np.asarray(target)
        depth = (sample - position) @ ((target - position) / np.linalg.norm(target - position))
        near = max(depth.min() * 0.8, 1e-3 * depth.max())
        camera.SetClippingRange(near, depth.max() * 1.2)

    def shift_camera(self, by: Array) -> None:
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*(self._stand[0] + by))
        camera.SetFocalPoint(*(self._stand[1] + by))

    def mark(self, point: Array | None, text: str, planes: Planes = ()) -> None:
        """A ring at a point with a text beside it, over all that is drawn; of the images of mirrored copies at that
        which is nearest to the camera. None: no mark in this picture."""
        if not self._mark:
            ring, label = (self.add_text("", 0, 0, points, bold=True) for points in (0.034, 0.022))
            ring.GetTextProperty().SetBackgroundOpacity(0)
            ring.GetTextProperty().SetJustificationToCentered()
            ring.GetTextProperty().SetVerticalJustificationToCentered()
            self._mark = [ring, label]
            for actor in self._mark:
                actor.GetPositionCoordinate().SetCoordinateSystemToWorld()
        for actor in self._mark:
            actor.SetVisibility(point is not None)
        if point is None:
            return
        images = reflect(np.reshape(point, (1, 3)), planes)
        point = images[np.argmin(np.linalg.norm(images - self.renderer.GetActiveCamera().GetPosition(), axis=1))]
        ring, label = self._mark
        for actor in self._mark:
            actor.GetPositionCoordinate().SetValue(*point)
        ring.SetInput("\u25cb")
        share = ring.GetPositionCoordinate().GetComputedViewportValue(self.renderer)[0] / (self.width * self.scale)
        if share > MARK_TO_THE_LEFT:  # the colour bar stands at the right
            label.SetInput(f"{text}     ")
            label.GetTextProperty().SetJustificationToRight()
        else:
            label.SetInput(f"     {text}")
            label.GetTextProperty().SetJustificationToLeft()

    def add_color_bar(self, lut: Any, title: str, labels: int, note: str) -> None:
        """labels: how many numbers the bar has. note: a line below it."""
        bar = vtkScalarBarActor()
        bar.SetLookupTable(lut)
        bar.SetTitle("")
        bar.SetNumberOfLabels(labels)
        bar.SetLabelFormat(" %.4g")
        bar.UnconstrainedFontSizeOn()
        bar.SetBarRatio(0.22)
        self._set_font(bar.GetLabelTextProperty(), 0.023)
        bar.DrawBackgroundOn()  # bodies may lie behind it where the scene is magnified
        bar.GetBackgroundProperty().SetColor(1, 1, 1)
        bar.GetBackgroundProperty().SetOpacity(VEIL)
        bar.SetPosition(0.885, 0.27)
        bar.SetPosition2(0.1, 0.5)
        self.renderer.AddActor2D(bar)
        # VTK would centre the title over the bar, where a long one runs out of the picture.
        lines = [part for line in title.split("\n") for part in textwrap.wrap(line, 18)]
        self.add_text("\n".join(lines), 0.975, 0.79, 0.026, right=True)
        if note:
            self.add_text(note, 0.975, 0.21, 0.02, right=True)

    def add_text(self, text: str, x: float, y: float, points: float, right: bool = False, color: Sequence[float] = INK,
                 bold: bool = False) -> Any:
        actor = vtk.vtkTextActor()
        actor.SetInput(text)
        self._set_font(actor.GetTextProperty(), points)
        actor.GetTextProperty().SetColor(*color)
        actor.GetTextProperty().SetBold(bold)
        actor.GetTextProperty().SetBackgroundColor(1, 1, 1)
        actor.GetTextProperty().SetBackgroundOpacity(VEIL)
        if right:
            actor.GetTextProperty().SetJustificationToRight()
        actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        actor.SetPosition(x, y)
        self.renderer.AddActor2D(actor)
        return actor

    def add_legend_entry(self, row: int, color: Sequence[float], name: str) -> None:
        y = 0.7 - 0.05 * row
        patch = self.add_text("ii", 0.875, y, 0.026, color=color)  # its background hides the letters
        patch.GetTextProperty().SetBackgroundColor(*color)
        patch.GetTextProperty().SetBackgroundOpacity(1)
        self.add_text(name if len(name) <= 14 else name[:13] + "\u2026", 0.9, y, 0.026)

    def _set_font(self, text: Any, points: float) -> None:
        if os.path.exists(FONT):
            text.SetFontFamily(VTK_FONT_FILE)
            text.SetFontFile(FONT)
        else:  # VTK's own, which has fewer signs
            text.SetFontFamilyToArial()
        text.SetFontSize(max(8, round(points * self.height * self.scale)))
        text.SetColor(*INK)
        text.SetBold(False)
        text.SetItalic(False)
        text.SetShadow(False)

    def draw(self) -> Array:
        """The picture as [height][width][3] bytes, at `supersampling` times the size."""
        self.window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()  # it would draw everything a second time
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        return np.asarray(vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1])
