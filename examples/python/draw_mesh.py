#!/usr/bin/env python3
"""Draws a picture of a mesh, cut open, by VTK: draw_mesh.py [SURFACE [PICTURE.png]]

VTK needs a display, as that of `xvfb-run -a python3 draw_mesh.py` on a machine without a screen.
"""
import os
import sys
import tempfile

try:
    import numpy as np
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, which draws
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                             vtkWindowToImageFilter)
except ImportError as error:
    print("skipped: %s (python3-numpy, python3-vtk9)" % error)
    sys.exit(77)

import boundary_recovery as br


def draw(mesh, file):
    """The tetrahedra behind a plane."""
    grid = mesh.to_vtk(surface=False)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    middle = (low + high) / 2
    plane = vtkPlane()
    plane.SetOrigin(middle)
    plane.SetNormal(0.9, 0.4, 0)
    cut = vtkExtractGeometry()
    cut.SetInputData(grid)
    cut.SetImplicitFunction(plane)
    sides = vtkGeometryFilter()
    sides.SetInputConnection(cut.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sides.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.95, 0.65, 0.3)
    actor.GetProperty().EdgeVisibilityOn()

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle)
    camera.SetPosition(middle + np.linalg.norm(high - low) * np.array([0.7, 0.4, 1.2]))
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.6)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.Update()
    writer = vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())


def main():
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        print("skipped: there is no display; `xvfb-run -a` (xvfb, xauth) makes one")
        sys.exit(77)
    data = os.environ.get("CGAL_DATA_DIR", os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data"))
    surface = br.read(sys.argv[1] if len(sys.argv) > 1 else os.path.join(data, "meshes", "gear_br3.off"))
    mesh = br.tetrahedralize(surface.points, surface.triangles)
    with tempfile.TemporaryDirectory() as folder:
        file = sys.argv[2] if len(sys.argv) > 2 else os.path.join(folder, "mesh.png")
        pixels = draw(mesh, file)
        print("%s: %d bytes" % (os.path.basename(file), os.path.getsize(file)))
        share = (pixels < 250).any(axis=1).mean()
        print("%d %% of the picture show the mesh" % (100 * share))
        assert 0.1 < share < 0.9


main()
