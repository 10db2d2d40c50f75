#!/usr/bin/env python3
"""Writes tests/core/data/files with other software than Gaspard: netCDF4, h5py, scipy, VTK and meshio.

Needs python3-netcdf4 python3-h5py python3-scipy python3-vtk9 python3-meshio python3-numpy. The values at (x, y) are
    f(x, y) = 1 + 2 x - 3 y + x y
unless a comment says otherwise; tests/core/data/field_file_test.cpp knows them.
"""
import pathlib

import h5py
import meshio
import netCDF4
import numpy as np
import scipy.io
import vtk
from vtk.util.numpy_support import numpy_to_vtk

folder = pathlib.Path(__file__).parent / "files"
folder.mkdir(exist_ok=True)


def f(x, y):
    return 1 + 2 * x - 3 * y + x * y


def netcdf(name, format="NETCDF3_CLASSIC"):
    return netCDF4.Dataset(folder / name, "w", format=format)


def axis(file, name, values, **attributes):
    file.createDimension(name, len(values))
    variable = file.createVariable(name, "f8", (name,))
    variable.setncatts(attributes)
    variable[:] = values
    return variable


def packed_globe(name, format):
    """lat descending, lon 0 to 360, shorts with scale, offset and fill values; times and levels."""
    with netcdf(name, format) as file:
        lat = np.linspace(80, -80, 9)
        lon = np.arange(0, 360, 30.0)
        axis(file, "lat", lat, units="degrees_north", standard_name="latitude")
        axis(file, "lon", lon, units="degrees_east", standard_name="longitude")
        axis(file, "time", [0.0, 6.0], units="hours since 2000-01-01")
        axis(file, "lev", [1000.0, 500.0, 100.0], units="hPa", positive="down")
        height = file.createVariable("height", "i2", ("time", "lev", "lat", "lon"), fill_value=-32768)
        height.setncatts({"scale_factor": 0.5, "add_offset": 100.0, "valid_range": np.array([-1000, 3000], "i2"),
                          "missing_value": np.int16(-999)})
        height.set_auto_maskandscale(False)
        i = np.arange(12)[None, None, None, :]
        j = np.arange(9)[None, None, :, None]
        k = np.arange(3)[None, :, None, None]
        t = np.arange(2)[:, None, None, None]
        stored = (i + 20 * j + 200 * k + 1000 * t).astype("i2")
        stored[0, 0, 0, 0] = -32768
        stored[0, 0, 0, 1] = -999
        stored[0, 0, 0, 2] = 3001
        stored[0, 0, 0, 3] = -1001
        height[:] = stored


packed_globe("globe-classic.nc", "NETCDF3_CLASSIC")
packed_globe("globe-hdf5.nc", "NETCDF4")

with netcdf("plane-64bit.nc", "NETCDF3_64BIT_DATA") as file:  # dimensions in the order x, y; no units
    x, y = np.array([0, 0.25, 1.0, 1.5]), np.array([-1, 0.5, 2.0])
    axis(file, "x", x)
    axis(file, "y", y)
    file.createVariable("value", "f8", ("x", "y"))[:] = f(x[:, None], y[None, :])
    flags = file.createVariable("flags", "u1", ("y", "x"))
    flags[:] = 250 * np.ones((3, 4))

with netcdf("large-chunk.nc", "NETCDF4") as file:  # refused; without values
    file.createDimension("time", 40)
    file.createDimension("y", 1000)
    file.createDimension("x", 1000)
    file.createVariable("value", "f8", ("time", "y", "x"), chunksizes=(40, 1000, 1000))

with netcdf("groups.nc", "NETCDF4") as file:  # refused
    for name in ("land", "ocean"):
        group = file.createGroup(name)
        axis(group, "x", np.arange(2.0))
        axis(group, "y", np.arange(2.0))
        group.createVariable("value", "f8", ("y", "x"))[:] = 1


def hdf5(name, add):
    """Refused: data of other files; those of external.nc exist on most machines."""
    with h5py.File(folder / name, "w", libver="earliest" if name != "virtual.nc" else "latest",
                   track_order=True) as file:
        for key in "xy":
            file.create_dataset(key, data=np.arange(4.0)).make_scale(key)
        add(file)
        if "value" in file and name != "link.nc":
            file["value"].dims[0].attach_scale(file["y"])
            file["value"].dims[1].attach_scale(file["x"])


def virtual(file):
    layout = h5py.VirtualLayout(shape=(4, 4), dtype="u1")
    layout[:] = h5py.VirtualSource("external.nc", "value", shape=(4, 4))
    file.create_virtual_dataset("value", layout)


def linked(file):
    file.create_group("more")["value"] = h5py.ExternalLink("plane.nc", "value")


hdf5("external.nc", lambda file: file.create_dataset("value", (4, 4), "u1", external=[("/etc/passwd", 0, 16)]))
hdf5("virtual.nc", virtual)
hdf5("link.nc", linked)

with netcdf("no-scale.nc") as file:  # refused
    axis(file, "x", np.arange(2.0))
    axis(file, "y", np.arange(2.0))
    file.createVariable("value", "f8", ("y", "x")).scale_factor = 0.0

with netcdf("curvilinear.nc", "NETCDF4_CLASSIC") as file:  # coordinates in two dimensions
    file.createDimension("j", 3)
    file.createDimension("i", 4)
    i, j = np.meshgrid(np.arange(4), np.arange(3))
    for key, unit, values in (("lon", "degrees_east", 10 + 2 * i + 0.1 * j), ("lat", "degrees_north", 45 + j - 0.2 * i)):
        variable = file.createVariable(key, "f4", ("j", "i"))
        variable.units = unit
        variable[:] = values
    sst = file.createVariable("sst", "f4", ("j", "i"), fill_value=1e20)
    sst.coordinates = "lon lat"
    values = f(i, j).astype("f4")
    values[2, 3] = 1e20
    sst[:] = values

with scipy.io.netcdf_file(folder / "scipy.nc", "w") as file:  # no coordinates at all
    file.createDimension("rows", 3)
    file.createDimension("columns", 5)
    variable = file.createVariable("v", "f4", ("rows", "columns"))
    variable[:] = f(np.arange(5)[None, :], np.arange(3)[:, None])


def with_arrays(data, x, y, cells):
    values = numpy_to_vtk(f(x, y), deep=1)
    values.SetName("f")
    data.GetPointData().SetScalars(values)
    vectors = numpy_to_vtk(np.stack([3 * x, 4 * x, 0 * x], axis=1), deep=1)
    vectors.SetName("velocity")
    data.GetPointData().SetVectors(vectors)
    of_cells = numpy_to_vtk(np.arange(cells, dtype="i4"), deep=1)
    of_cells.SetName("number")
    data.GetCellData().AddArray(of_cells)
    return data


def write(writer, name, data, **settings):
    for key, value in settings.items():
        getattr(writer, key)(value)
    writer.SetFileName(str(folder / name))
    writer.SetInputData(data)
    assert writer.Write() == 1


def image():
    data = vtk.vtkImageData()
    data.SetDimensions(4, 3, 1)
    data.SetOrigin(-1, 2, 0)
    data.SetSpacing(0.5, 0.25, 1)
    y, x = np.meshgrid(2 + 0.25 * np.arange(3), -1 + 0.5 * np.arange(4), indexing="ij")
    return with_arrays(data, x.ravel(), y.ravel(), 6)


def rectilinear():
    data = vtk.vtkRectilinearGrid()
    data.SetDimensions(4, 3, 1)
    xs, ys = np.array([0, 0.25, 1.0, 1.5]), np.array([-1, 0.5, 2.0])
    data.SetXCoordinates(numpy_to_vtk(xs, deep=1))
    data.SetYCoordinates(numpy_to_vtk(ys, deep=1))
    data.SetZCoordinates(numpy_to_vtk(np.zeros(1), deep=1))
    y, x = np.meshgrid(ys, xs, indexing="ij")
    return with_arrays(data, x.ravel(), y.ravel(), 6)


def points_of(x, y, z):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, y, z], axis=1), deep=1))
    return points


def structured():  # a quarter of an annulus
    data = vtk.vtkStructuredGrid()
    data.SetDimensions(4, 3, 1)
    r, a = np.meshgrid(1 + np.arange(3) / 2, np.arange(4) * np.pi / 6, indexing="ij")
    x, y = (r * np.cos(a)).ravel(), (r * np.sin(a)).ravel()
    data.SetPoints(points_of(x, y, 0 * x))
    return with_arrays(data, x, y, 6)


def triangles(data):  # two triangles and a quadrilateral
    x, y = np.array([0, 1, 1, 0, 2, 2.0]), np.array([0, 0, 1, 1, 0, 1.5])
    data.SetPoints(points_of(x, y, 0 * x))
    data.Allocate(3)
    for kind, corners in ((vtk.VTK_TRIANGLE, (0, 1, 2)), (vtk.VTK_TRIANGLE, (0, 2, 3)), (vtk.VTK_QUAD, (1, 4, 5, 2))):
        ids = vtk.vtkIdList()
        for corner in corners:
            ids.InsertNextId(corner)
        data.InsertNextCell(kind, ids)
    return with_arrays(data, x, y, 3)


for name, make, writer in (("image", image, vtk.vtkStructuredPointsWriter),
                           ("rectilinear", rectilinear, vtk.vtkRectilinearGridWriter),
                           ("structured", structured, vtk.vtkStructuredGridWriter),
                           ("unstructured", lambda: triangles(vtk.vtkUnstructuredGrid()), vtk.vtkUnstructuredGridWriter),
                           ("polydata", lambda: triangles(vtk.vtkPolyData()), vtk.vtkPolyDataWriter)):
    one = writer()
    one.SetFileTypeToASCII()
    write(one, name + "-ascii.vtk", make())
    one = writer()
    one.SetFileTypeToBinary()
    write(one, name + "-binary.vtk", make())
    if hasattr(one, "SetFileVersion"):
        one = writer()
        one.SetFileVersion(one.VTK_LEGACY_READER_VERSION_4_2)
        one.SetFileTypeToBinary()
        write(one, name + "-4.vtk", make())

xml = {"vti": (image, vtk.vtkXMLImageDataWriter), "vtr": (rectilinear, vtk.vtkXMLRectilinearGridWriter),
       "vts": (structured, vtk.vtkXMLStructuredGridWriter),
       "vtu": (lambda: triangles(vtk.vtkUnstructuredGrid()), vtk.vtkXMLUnstructuredGridWriter),
       "vtp": (lambda: triangles(vtk.vtkPolyData()), vtk.vtkXMLPolyDataWriter)}
for ending, (make, writer) in xml.items():
    for mode in ("Ascii", "Binary", "Appended"):
        one = writer()
        getattr(one, "SetDataModeTo" + mode)()
        one.SetCompressor(None)
        one.EncodeAppendedDataOff()
        one.SetHeaderTypeToUInt32() if mode == "Binary" else one.SetHeaderTypeToUInt64()
        write(one, f"{mode.lower()}.{ending}", make())
one = vtk.vtkXMLUnstructuredGridWriter()
one.SetDataModeToAppended()
one.EncodeAppendedDataOn()
one.SetCompressorTypeToZLib()
one.SetByteOrderToBigEndian()
one.SetBlockSize(64)
write(one, "big-base64-zlib.vtu", triangles(vtk.vtkUnstructuredGrid()))
one = vtk.vtkXMLImageDataWriter()
one.SetDataModeToAppended()
one.EncodeAppendedDataOff()
one.SetCompressorTypeToZLib()
one.SetBlockSize(64)
write(one, "raw-zlib.vti", image())
one = vtk.vtkXMLImageDataWriter()
one.SetDataModeToAppended()
one.SetCompressorTypeToLZ4()
write(one, "lz4.vti", image())

x, y = np.array([0, 1, 1, 0, 2, 2.0]), np.array([0, 0, 1, 1, 0, 1.5])
mesh = meshio.Mesh(np.stack([x, y, 0 * x], axis=1), [("triangle", [[0, 1, 2], [0, 2, 3]]), ("quad", [[1, 4, 5, 2]])],
                   point_data={"f": f(x, y)}, cell_data={"number": [np.array([0, 1]), np.array([2])]})
for compression in ("zlib", None):
    mesh.write(folder / f"meshio-{compression or 'plain'}.vtu", compression=compression)
mesh.write(folder / "meshio.vtk", binary=False)

y, x = np.meshgrid(np.linspace(0, 1, 3), np.linspace(0, 1, 4), indexing="ij")
np.savetxt(folder / "numpy.csv", np.stack([x.ravel(), y.ravel(), f(x, y).ravel()], axis=1), header="x y f")

# Fields in space, with g(x, y, z) = f(x, y) + 4 z + x y z.


def g(x, y, z):
    return f(x, y) + 4 * z + x * y * z


lines = {"x": np.array([0, 0.5, 1, 2]), "y": np.array([3, 2, 1, 0.5, 0]), "z": np.array([-1, 0, 0.25])}
with netcdf("space.nc") as file:  # y descends, z is the slowest direction and x in the middle
    for name, values in lines.items():
        axis(file, name, values, axis=name.upper())
    file.createVariable("ground", "f8", ("y", "x"))[:] = 7
    file.createVariable("g", "f8", ("z", "x", "y"))[:] = g(
        lines["x"][None, :, None], lines["y"][None, None, :], lines["z"][:, None, None])
with netcdf("members.nc") as file:  # two dimensions that are no axes
    for name, length in (("member", 3), ("stage", 2), ("y", 2), ("x", 2), ("z", 2), ("row", 2)):
        file.createDimension(name, length)
    file.createVariable("v", "i2", ("member", "stage", "y", "x"))[:] = np.arange(24).reshape(3, 2, 2, 2)
    file.createVariable("w", "i2", ("member", "z", "row", "x"))[:] = np.arange(24).reshape(3, 2, 2, 2)
with netcdf("space-points.nc") as file:
    at = np.random.default_rng(2).uniform(0, 1, (3, 30))
    file.createDimension("node", 30)
    for name, values in zip("xyz", at):
        file.createVariable(name, "f8", ("node",))[:] = values
    one = file.createVariable("g", "f8", ("node",))
    one.coordinates = "x y z"
    one[:] = g(*at)


def lattice(data, x, y, z):
    data.SetDimensions(len(x), len(y), len(z))
    z, y, x = np.meshgrid(z, y, x, indexing="ij")
    values = numpy_to_vtk(g(x, y, z).ravel(), deep=True)
    values.SetName("g")
    data.GetPointData().AddArray(values)
    return x.ravel(), y.ravel(), z.ravel()


cube = vtk.vtkImageData()
lattice(cube, 0.5 * np.arange(4) - 1, 0.25 * np.arange(3) + 2, 2.0 * np.arange(3))
cube.SetOrigin(-1, 2, 0)
cube.SetSpacing(0.5, 0.25, 2)
write(vtk.vtkXMLImageDataWriter(), "space.vti", cube)
write(vtk.vtkStructuredPointsWriter(), "space.vtk", cube)
block = vtk.vtkStructuredGrid()
x, y, z = lattice(block, np.arange(3.0), np.arange(4.0), np.arange(3.0))
block.SetPoints(points_of(x, y, z))
write(vtk.vtkXMLStructuredGridWriter(), "space.vts", block)
corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 2.0]])
meshio.Mesh(corners, [("tetra", [[0, 1, 2, 3], [1, 2, 3, 4]])], point_data={"g": g(*corners.T)},
            cell_data={"number": [np.array([0.0, 1.0])]}).write(folder / "space.vtu")
