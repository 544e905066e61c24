"""Labels through and through: data arrays of xarray as frequencies and frictions give answers with dims, coordinates and units, which xarray
draws and pandas tabulates."""

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr

import stickslip as ss

numbers = np.linspace(0.3, 3, 120)
hertz = xr.DataArray(numbers, dims="frequency", coords={"frequency": numbers}, attrs={"units": "Hz"})
pads = xr.DataArray([0.02, 0.05, 0.08], dims="pad", coords={"pad": ["PTFE", "worn", "dusty"]})
isolator = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=pads, damping_ratio="3%", units="N,mm")
drive = ss.Drive(base_acceleration="0.1 g", frequency=hertz, units="N,mm")
data = isolator.steady(drive, outputs=["max_displacement"]).to_xarray()
axes = plt.figure(layout="constrained").gca()
data["max_displacement"].plot.line(x="frequency", ax=axes)
axes.set(yscale="log", xlabel="frequency (Hz)", ylabel=f"peak displacement ({data['max_displacement'].attrs['units']})")
worst = data["max_displacement"].max("frequency").to_series()
assert worst["PTFE"] > worst["worn"] > worst["dusty"]
