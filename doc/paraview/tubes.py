#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
"""Draw a run: fibers as tubes of their radius, interaction forces as arrows.

    python3 doc/paraview/tubes.py DIRECTORY [TIME] [--view X,Y,Z] [--color FIELD]

writes DIRECTORY/fibers.png of the output at TIME, or of the last one. Needs VTK
for Python (Debian package python3-vtk9), or runs with ParaView's pvpython. Inside
ParaView the same comes from the filters Extract Surface, Clean, Tube and Glyph.
"""

import argparse
import os
import sys
import xml.etree.ElementTree as xml

import vtk


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("time", nargs="?", type=float, help="default: the last")
    parser.add_argument("--view", default="0.3,-1,0.5",
                        help="direction from the fibers to the eye: x,y,z")
    parser.add_argument("--color", default="axial_force",
                        help="point field of fibers.pvd to color the tubes by")
    return parser.parse_args()


def read(directory, name, time):
    """The output of a .pvd collection that is nearest to a time."""
    collection = os.path.join(directory, name)
    if not os.path.exists(collection):
        return None
    outputs = [(float(entry.get("timestep")), entry.get("file"))
               for entry in xml.parse(collection).iter("DataSet")]
    last = outputs[-1] if time is None else min(
        outputs, key=lambda output: abs(output[0] - time))
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(directory, last[1]))
    reader.Update()
    return reader.GetOutput()


def tubes(grid, color):
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(surface.GetOutputPort())
    lines = vtk.vtkStripper()
    lines.SetInputConnection(clean.GetOutputPort())
    lines.Update()
    output = lines.GetOutput()
    output.GetPointData().SetActiveScalars("radius")
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(output)
    tube.SetNumberOfSides(24)
    tube.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tube.CappingOn()

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    array = output.GetPointData().GetArray(color)
    if array is None:
        sys.exit(f"There is no field '{color}' in fibers.pvd.")
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(color)
    mapper.CreateDefaultLookupTable()
    mapper.GetLookupTable().SetHueRange(2. / 3., 0.)  # from blue to red
    if array.GetNumberOfComponents() > 1:
        mapper.GetLookupTable().SetVectorModeToMagnitude()
        mapper.SetScalarRange(array.GetRange(-1))
    else:
        mapper.SetScalarRange(array.GetRange())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor, mapper


def arrows(cloud, length):
    """Forces as arrows, the largest one of the given length."""
    force = cloud.GetPointData().GetArray("force_per_length")
    largest = 0. if force is None else force.GetRange(-1)[1]
    if largest == 0.:
        return None
    cloud.GetPointData().SetActiveVectors("force_per_length")
    arrow = vtk.vtkArrowSource()
    glyph = vtk.vtkGlyph3D()
    glyph.SetInputData(cloud)
    glyph.SetSourceConnection(arrow.GetOutputPort())
    glyph.SetVectorModeToUseVector()
    glyph.SetScaleModeToScaleByVector()
    glyph.SetScaleFactor(length / largest)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(glyph.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.1, 0.6, 0.2)
    return actor


def main():
    arguments = parse_arguments()
    fibers = read(arguments.directory, "fibers.pvd", arguments.time)
    if fibers is None:
        sys.exit(f"There is no fibers.pvd in {arguments.directory}.")

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    tube_actor, mapper = tubes(fibers, arguments.color)
    renderer.AddActor(tube_actor)

    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle(arguments.color)
    bar.GetTitleTextProperty().SetColor(0, 0, 0)
    bar.GetLabelTextProperty().SetColor(0, 0, 0)
    bar.SetWidth(0.08)
    bar.SetHeight(0.5)
    renderer.AddActor2D(bar)

    cloud = read(arguments.directory, "interaction.pvd", arguments.time)
    if cloud is not None and cloud.GetNumberOfPoints() > 0:
        arrow_actor = arrows(cloud, 0.1 * fibers.GetLength())
        if arrow_actor is not None:
            renderer.AddActor(arrow_actor)

    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*[float(x) for x in arguments.view.split(",")])
    camera.SetViewUp(0, 0, 1)
    if camera.GetPosition()[:2] == (0, 0):
        camera.SetViewUp(0, 1, 0)
    renderer.ResetCamera()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1200, 900)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    picture = os.path.join(arguments.directory, "fibers.png")
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    print(f"Picture: {picture}")


if __name__ == "__main__":
    main()
