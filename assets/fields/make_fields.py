#!/usr/bin/env python3
"""Makes the fields of the shipped scenarios, all of them invented, and writes these scenarios:

  vortices.nc    vorticity of two rows of vortices, periodic in x and y; NetCDF, packed as 16-bit integers
  planet.nc      height of the surface of a planet with craters and a strip without data; NetCDF by the CF conventions,
                 packed, with fill values, latitudes from north to south, longitudes 0 to 355
  stations.csv   a front crossing stations at random places of a quarter annulus; CSV with the columns x, y, rain

flow-vortices.nc is not made here: bench/flow.cpp computes it (docs/flow.md).

Usage: make_fields.py [FOLDER]. Needs numpy and netCDF4; the results are in the repository, so that building the program
needs neither."""
import sys
from pathlib import Path

import netCDF4
import numpy as np


def axis(file, name, values, **attributes):
    file.createDimension(name, len(values))
    variable = file.createVariable(name, "f4", (name,))
    variable.setncatts(attributes)
    variable[:] = values


def packed(file, name, values, dimensions, scale, missing=None, **attributes):
    variable = file.createVariable(name, "i2", dimensions, fill_value=-32768)
    variable.setncatts({"scale_factor": scale, "add_offset": 0.0, **attributes})
    variable.set_auto_maskandscale(False)
    stored = np.round(values / scale).astype("i2")
    if missing is not None:
        stored[missing] = -32768
    variable[:] = stored


def vortices(path):
    n = 48
    x, y = np.meshgrid(np.arange(n) / n, np.arange(n) / n)
    vorticity = np.zeros((n, n))
    for k in range(4):
        for sign, cx, cy in ((1, k / 4, 0.36), (-1, k / 4 + 0.125, 0.64)):
            dx, dy = (x - cx + 0.5) % 1 - 0.5, (y - cy + 0.5) % 1 - 0.5
            vorticity += sign * np.exp(-(dx**2 + dy**2) / 0.045**2)
    with netCDF4.Dataset(path, "w", format="NETCDF3_CLASSIC") as file:
        file.setncatts({"Conventions": "CF-1.8", "title": "two rows of vortices"})
        axis(file, "x", np.arange(n) / n, units="m", axis="X")
        axis(file, "y", np.arange(n) / n, units="m", axis="Y")
        packed(file, "vorticity", vorticity, ("y", "x"), 1e-4, units="s-1")


def planet(path):
    lon, lat = np.arange(0, 360, 5.0), np.arange(87.5, -90, -5)
    a, b = np.meshgrid(np.radians(lon), np.radians(lat))
    x = np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])
    random = np.random.default_rng(5)
    height = 300 * np.sin(2 * a) * np.cos(b) ** 2
    for k in range(14):
        centre = random.normal(size=3)
        centre /= np.linalg.norm(centre)
        radius = random.uniform(0.12, 0.4)
        distance = np.arccos(np.clip(np.tensordot(centre, x, 1), -1, 1)) / radius
        height += 3000 * radius * (1.6 * np.exp(-((distance - 1) / 0.22) ** 2) - np.exp(-((distance / 0.8) ** 4)))
    with netCDF4.Dataset(path, "w", format="NETCDF3_CLASSIC") as file:
        file.setncatts({"Conventions": "CF-1.8", "title": "an invented planet"})
        axis(file, "lat", lat, units="degrees_north", standard_name="latitude")
        axis(file, "lon", lon, units="degrees_east", standard_name="longitude")
        packed(file, "height", height, ("lat", "lon"), 0.5, np.abs(np.degrees(a) + 8 * np.sin(5 * b) - 250) < 6,
               units="m", long_name="height of the surface")


def stations(path):
    random = np.random.default_rng(7)
    radius, angle = np.sqrt(random.uniform(0.24, 1.02, 260)), random.uniform(-0.02, np.pi / 2 + 0.02, 260)
    x, y = radius * np.cos(angle), radius * np.sin(angle)
    front = np.exp(-(((x + 0.18 * np.sin(6 * y) - 0.52) / 0.09) ** 2))
    rows = [f"{a:.3f},{b:.3f},{12 * v:.2f}" for a, b, v in zip(x, y, front)]
    path.write_text("x,y,rain\n" + "\n".join(rows) + "\n")


def scenario(path, title, description, domain, data, monitor, method):
    text = f'title = "{title}"\ndescription = "{description}"\n\n[domain]\n{domain}\n\n[monitor]\ntype = "field"\n'
    text += f'{monitor}\nfile = "gaspard:{data.name}"\n\n[method]\n{method}\n'
    path.write_text(text)


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    scenarios = folder if len(sys.argv) > 1 else folder.parent / "scenarios"
    for make, name in ((vortices, "vortices.nc"), (planet, "planet.nc"), (stations, "stations.csv")):
        make(folder / name)
    scenario(scenarios / "plane-field.toml", "Vortices from a file",
             "Vorticity from a NetCDF file: cells are small where its absolute value is large",
             'type = "plane"\nboundary = "periodic"\ncells = 60', folder / "vortices.nc",
             'variable = "vorticity"\ntransform = "absolute"\ncontrast = 20.0', 'type = "auto"')
    scenario(scenarios / "sphere-field.toml", "Craters from a file",
             "Height of a planet from a NetCDF file with a strip of missing values: cells are small where it is high",
             'type = "cubed-sphere"', folder / "planet.nc", 'variable = "height"\ncontrast = 10.0',
             'type = "auto"')
    scenario(scenarios / "spline-field.toml", "Stations from a file",
             "Measurements at 260 places from a CSV file, by a moving least-squares fit, on a quarter annulus",
             'type = "spline-annulus"\ncells = 32', folder / "stations.csv", 'variable = "rain"\ncontrast = 10.0', 'type = "auto"')


if __name__ == "__main__":
    main()
