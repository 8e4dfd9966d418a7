#!/usr/bin/env python3
"""Writes the samples of this folder with VTK: the same particles and the same mesh through every encoding.

Run as `make_samples.py FOLDER` with a python3 that has the module vtk. What the values are stands in particles() and mesh() and again in the tests.
"""

import sys

import vtk

TYPES = {"Int8": vtk.vtkSignedCharArray, "UInt8": vtk.vtkUnsignedCharArray, "Int16": vtk.vtkShortArray, "UInt16": vtk.vtkUnsignedShortArray,
         "Int32": vtk.vtkIntArray, "UInt32": vtk.vtkUnsignedIntArray, "Int64": vtk.vtkTypeInt64Array, "UInt64": vtk.vtkTypeUInt64Array,
         "Float32": vtk.vtkFloatArray, "Float64": vtk.vtkDoubleArray}


def array(kind, name, rows):
    filled = TYPES[kind]()
    filled.SetName(name)
    filled.SetNumberOfComponents(len(rows[0]))
    for row in rows:
        filled.InsertNextTuple(row)
    return filled


def points(rows):
    made = vtk.vtkPoints()
    made.SetDataTypeToDouble()
    for row in rows:
        made.InsertNextPoint(row)
    return made


def with_time(data, time):
    data.GetFieldData().AddArray(array("Float64", "TimeValue", [(time,)]))
    return data


def particles(data, specials=True):
    """Seven particles, in a vtkPolyData or vtkUnstructuredGrid, with an array of each type."""
    data.SetPoints(points([(0.1 * i, 1 / (i + 1), 0) for i in range(7)]))
    if data.IsA("vtkPolyData"):
        verts = vtk.vtkCellArray()
        for i in range(7):
            verts.InsertNextCell(1, [i])
        data.SetVerts(verts)
    else:
        for i in range(7):
            data.InsertNextCell(vtk.VTK_VERTEX, 1, [i])
    held = data.GetPointData()
    for kind in TYPES:
        held.AddArray(array(kind, kind, [(3 * i + 1,) for i in range(7)]))
    held.AddArray(array("Float64", "velocity", [(i / 3, -i / 7, 1e-300 * i) for i in range(7)]))
    held.AddArray(array("Float32", "wide <&> name", [(i / 3,) for i in range(7)]))
    if specials:  # text has no digits for these
        held.AddArray(array("Float64", "specials", [(float(v),) for v in ("nan", "inf", "-inf", "-0.0", "5e-324", "1.7976931348623157e308", "1")]))
    return with_time(data, 0.125)


def mesh():
    """A cell of each kind, side by side along x, with a polyhedron that is a cube; volumes 1/6, 1, 1, 1/2, 1/3, 1."""
    grid = vtk.vtkUnstructuredGrid()
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [(vtk.VTK_TETRA, [0, 1, 3, 4]), (vtk.VTK_VOXEL, [0, 1, 3, 2, 4, 5, 7, 6]), (vtk.VTK_HEXAHEDRON, list(range(8))),
             (vtk.VTK_WEDGE, [0, 1, 3, 4, 5, 7]), (vtk.VTK_PYRAMID, [0, 1, 2, 3, 4])]
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    grid.SetPoints(points([(x + 2 * k, y, z) for k in range(6) for x, y, z in corners]))
    for k, (kind, ids) in enumerate(cells):
        grid.InsertNextCell(kind, len(ids), [8 * k + i for i in ids])
    stream = vtk.vtkIdList()
    for number in [len(faces)] + [n for face in faces for n in [len(face)] + [40 + i for i in face]]:
        stream.InsertNextId(number)
    grid.InsertNextCell(vtk.VTK_POLYHEDRON, stream)
    grid.GetPointData().AddArray(array("Float64", "height", [(p / 48,) for p in range(48)]))
    grid.GetCellData().AddArray(array("Float32", "p", [(k / 4,) for k in range(6)]))
    return with_time(grid, 0.25)


def plane():
    """Polygons of a vtkPolyData: a triangle, a square and a pentagon; areas 1/2, 1 and 1.5; a strip of two triangles, area 1."""
    data = vtk.vtkPolyData()
    data.SetPoints(points([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 2, 0)]))
    polys, strips = vtk.vtkCellArray(), vtk.vtkCellArray()
    for ids in ([0, 1, 2], [0, 1, 2, 3], [0, 1, 2, 4, 3]):
        polys.InsertNextCell(len(ids), ids)
    strips.InsertNextCell(4, [0, 1, 3, 2])
    data.SetPolys(polys)
    data.SetStrips(strips)
    data.GetCellData().SetScalars(array("Int32", "two", [(k, -k) for k in range(4)]))
    data.GetCellData().SetVectors(array("Float64", "U", [(k, 2 * k, 0) for k in range(4)]))
    data.GetCellData().SetTensors(array("Float32", "stress", [[k + i / 8 for i in range(9)] for k in range(4)]))
    return data


def write_xml(data, file, mode="appended", compressor=None, header=64, big_endian=False):
    name = data.GetClassName()
    writer = {"vtkPolyData": vtk.vtkXMLPolyDataWriter, "vtkUnstructuredGrid": vtk.vtkXMLUnstructuredGridWriter}[name]()
    writer.SetInputData(data)
    writer.SetFileName(file)
    writer.SetCompressorType({None: 0, "zlib": 1, "lz4": 2, "lzma": 3}[compressor])
    writer.SetBlockSize(64)  # several blocks
    {32: writer.SetHeaderTypeToUInt32, 64: writer.SetHeaderTypeToUInt64}[header]()
    (writer.SetByteOrderToBigEndian if big_endian else writer.SetByteOrderToLittleEndian)()
    {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
    writer.SetEncodeAppendedData(mode == "appended_base64")
    writer.Write()


def write_parallel(data, file, pieces):
    writer = vtk.vtkXMLPPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(file)
    writer.SetNumberOfPieces(pieces)
    writer.SetStartPiece(0)
    writer.SetEndPiece(pieces - 1)
    writer.Write()


def write_legacy(data, file, binary, version=None):
    name = data.GetClassName()
    writer = {"vtkPolyData": vtk.vtkPolyDataWriter, "vtkUnstructuredGrid": vtk.vtkUnstructuredGridWriter, "vtkImageData": vtk.vtkStructuredPointsWriter,
              "vtkRectilinearGrid": vtk.vtkRectilinearGridWriter, "vtkStructuredGrid": vtk.vtkStructuredGridWriter}[name]()
    writer.SetInputData(data)
    writer.SetFileName(file)
    writer.SetFileType(vtk.VTK_BINARY if binary else vtk.VTK_ASCII)
    if version:
        writer.SetFileVersion(version)
    writer.Write()


def structured():
    """3 x 2 x 1 points, as an image, with coordinates of each axis, and with coordinates of each point."""
    image, lines, grid = vtk.vtkImageData(), vtk.vtkRectilinearGrid(), vtk.vtkStructuredGrid()
    image.SetDimensions(3, 2, 1)
    image.SetOrigin(1, 2, 3)
    image.SetSpacing(0.5, 0.25, 1)
    lines.SetDimensions(3, 2, 1)
    for axis, values in zip("XYZ", ((1, 1.5, 2), (2, 2.25), (3,))):
        getattr(lines, f"Set{axis}Coordinates")(array("Float64", axis, [(v,) for v in values]))
    grid.SetDimensions(3, 2, 1)
    grid.SetPoints(points([(1 + 0.5 * i, 2 + 0.25 * j, 3) for j in range(2) for i in range(3)]))
    for data in (image, lines, grid):
        data.GetPointData().SetScalars(array("Float64", "p", [(k / 3,) for k in range(6)]))
        yield data


def main(folder):
    poly, cloud = particles(vtk.vtkPolyData()), particles(vtk.vtkUnstructuredGrid())
    for mode in ("binary", "appended", "appended_base64"):
        for compressor in (None, "zlib", "lz4"):
            for header in (32, 64) if mode == "appended" or compressor is None else (64,):
                write_xml(poly, f"{folder}/particles_{mode}_{compressor or 'plain'}_{header}.vtp", mode, compressor, header)
    write_xml(particles(vtk.vtkPolyData(), False), f"{folder}/particles_ascii.vtp", "ascii")
    write_xml(poly, f"{folder}/particles_big_endian.vtp", "appended", None, 32, True)
    write_xml(poly, f"{folder}/particles_big_endian_zlib.vtp", "binary", "zlib", 64, True)
    write_xml(poly, f"{folder}/particles_lzma.vtp", "appended", "lzma")
    write_xml(cloud, f"{folder}/particles.vtu", "appended", "zlib")
    write_xml(mesh(), f"{folder}/mesh_ascii.vtu", "ascii")
    write_xml(mesh(), f"{folder}/mesh.vtu", "appended", "lz4")
    write_xml(plane(), f"{folder}/plane.vtp", "appended")
    write_parallel(poly, f"{folder}/parallel.pvtp", 2)
    for binary, kind in ((False, "ascii"), (True, "binary")):
        write_legacy(particles(vtk.vtkPolyData(), binary), f"{folder}/particles_{kind}.vtk", binary)
        write_legacy(particles(vtk.vtkPolyData(), binary), f"{folder}/particles_{kind}_42.vtk", binary, 42)
        write_legacy(cloud if binary else particles(vtk.vtkUnstructuredGrid(), False), f"{folder}/cloud_{kind}.vtk", binary)
        write_legacy(mesh(), f"{folder}/mesh_{kind}.vtk", binary)
        write_legacy(mesh(), f"{folder}/mesh_{kind}_42.vtk", binary, 42)
        write_legacy(plane(), f"{folder}/plane_{kind}.vtk", binary)
    for data, name in zip(structured(), ("image", "lines", "grid")):
        write_legacy(data, f"{folder}/structured_{name}.vtk", name == "grid")


main(sys.argv[1])
