"""Writes `layouts/` and `layouts.json`: a small file in each layout of records, and what must be read of it.

The samples are synthetic: a decaying sine, rounded to the digits that the layout has. SAC, SLIST and TSPAIR are written, and
K-NET is read, by ObsPy (pip install obspy); the others are written here from the definitions of their agencies.
"""

import json
import math
import pathlib

import numpy as np
import obspy

HERE = pathlib.Path(__file__).parent
FOLDER = HERE / "layouts"
# SAC alphanumeric of ObsPy 1.5.1 is read only in whole rows of five.
COUNT, STEP, RATE = 45, 0.02, 50
FILES = {}


def wave(digits, size=27.0, phase=0.0):
    values = (size * math.exp(-(((i - 18) / 7) ** 2)) * math.sin(0.7 * i + phase) for i in range(COUNT))
    return [f"{value:.{digits}f}" for value in values]


def rows(words, width, per_line):
    lines = [words[i : i + per_line] for i in range(0, len(words), per_line)]
    return ["".join(f"{word:>{width}}" for word in line) for line in lines]


def peak(words):
    return max(words, key=lambda word: abs(float(word)))


def keep(name, text, kind, words, unit, step=STEP, times=None, options=None, scale=1.0, channel=None):
    data = text if isinstance(text, bytes) else ("\n".join(text) + "\n").encode("latin-1")
    (FOLDER / name).write_bytes(data)
    samples = [float(word) for word in words]
    FILES[name] = {
        "kind": kind,
        "unit": unit,
        "step": step,
        "times": times,
        "samples": samples,
        "scale": scale,
        "channel": channel,
        "options": options or {},
    }


def shortened(text):
    """A number in Fortran's format 1PE10.4E1: ` 2.7600E-2`."""
    mantissa, exponent = f"{float(text):.4E}".split("E")
    return f"{mantissa}E{'-' if int(exponent) < 0 else '+'}{abs(int(exponent))}"


def smc():
    words = [shortened(word) for word in wave(4)]
    integers = [-32768] * 48
    integers[1], integers[8], integers[13], integers[14], integers[15], integers[16] = 2001, 1, 90, 360, 2, COUNT
    reals = [1.7e38] * 50
    reals[1], reals[29], reals[31] = RATE, max(map(float, words)), min(map(float, words))
    text = ["2 CORRECTED ACCELEROGRAM", "*", "EXAM", "     2001   1   1    0000 Example", "Moment Mag=      6.0"]
    text += ["station = Example, Basement             component=    360", "epicentral dist =     10.0       pk     ="]
    text += ["inst type=SMA-1      data source = example", "*", "*", "*"]
    text += rows([str(i) for i in integers], 10, 8)
    text += rows([f"{r:.7E}" for r in reals], 15, 5)
    text += ["|", "|a comment with 1.0 2.0 numbers"] + rows(words, 10, 8)
    keep("smc.smc", text, "SMC", words, "cm/s²", channel="360")


def integers(count=COUNT):
    all = [0] * 100
    all[0:3], all[27] = [1, 1, 1], count
    return rows([str(i) for i in all], 5, 16)


def csmip_v1():
    words = wave(6, 0.08)
    text = ["Uncorrected Accelerogram Data             Processed: 01/01/20, CGS  example"]
    text += ["Record of Wed Jan  1, 2020 00:00:00.0 PST", "CSMIP Preliminary Processing", "0-0-0.01   Start time"]
    text += ["Station No. 00000   40.000N, 123.000W      Etna  s/n 0000  (2 Chns of  2 at Sta)", "Example"]
    head = ["Chan  {0}: {1} Deg", "Record of Wed Jan  1, 2020", "Hypocenter:  To be determined."]
    head += ["Instr Period =  .0109 sec,  Damping =  .670,  Sensitivity =  .63  v/g"]
    head += [f"No. of Points =  {COUNT}  Record Length =  {COUNT * STEP:.3f} sec   at {RATE} Samples/sec"]
    head += ["Units of uncor data are sec and g .        Max  =   {2:.3f} g , at  .360 sec."]
    head += ["RMS calc for complete record =        ."]
    def channel(number, angle, words):
        block = text + [line.format(number, angle, float(peak(words))) for line in head] + integers()
        block += rows([".0108814"] * 50, 10, 8)
        block += [f" {COUNT} Accelerogram points at {RATE} pts/sec in units of g .      Format: (8f9.6)"]
        return block + rows(words, 9, 8) + [f"/&  ----------  End of data for channel  {number}  ----------"]
    other = wave(6, 0.05, 1.0)
    all = channel(1, 360, words) + channel(2, 90, other)
    keep("csmip.V1", all, "CSMIP", other, "g", options={"column": "90 deg"}, channel="90 Deg")


def csmip_v2():
    words = wave(6)
    text = ["Corrected accelerogram   EXAMPLE    Chan  1:  90 Deg     from"]
    text += ["Uncorrected Accelerogram Data             Processed: 01/01/20"] + [f"Line {i}" for i in range(3, 15)]
    text += ["Accelerogram bandpass filtered with 3 dB pts at   .10 and 23.00 cyc/sec"]
    text += [f" {COUNT} points of instrument- and baseline-corrected accel, veloc and displ data"]
    text += [f"At equally-spaced intervals of    {STEP:.3f}  sec."]
    text += [f"Peak acceleration =   {float(peak(words)):.3f}    cm/sec/sec  at   0.360   sec."]
    text += ["Peak   velocity   =    -6.863      cm/sec    at   14.680   sec."] + [f"Line {i}" for i in range(20, 26)]
    text += rows(["-999"] * 100, 5, 16) + rows(["-999.00000"] * 100, 10, 8)
    text += [f" {COUNT} points of accel data equally spaced at  {STEP:.3f} sec, in cm/sec2. (8f10.6)"]
    text += rows(words, 10, 8)
    for name, unit in [("veloc", "cm/sec."), ("displ", "cm.")]:
        text += [f" {COUNT} points of {name} data equally spaced at  {STEP:.3f} sec, in {unit} (8f10.7)"]
        text += rows(wave(7, 1.0), 10, 8)
    text += ["/&  ----------  End of data for channel  1  ----------"]
    keep("csmip.V2", text, "CSMIP", words, "cm/s²", channel="90 Deg")


def pairs(name, kind, first, place, component, units, times, width):
    words = wave(3, 1.8)
    text = [first] + [f"EXAMPLE LINE {i}" for i in range(2, 14)]
    text[place], text[6] = kind, component
    if kind == "RENADIC":
        text[place] = "UNIVERSIDAD DE CHILE - RENADIC"
    text[9] = "INSTR PERIOD = 0.0400 SEC,  DAMPING =0.6000,  SENSITIVITY =1.000 VDC/G"
    text[10] = f"NO. OF POINTS =   {COUNT}  RECORD LENGTH = {times[-1]} SEC"
    text[11] = units.format(float(peak(words)) / 10)
    text += integers() + rows([".040"] * 50, 10, 8)
    text += rows([word for pair in zip(times, words) for word in pair], 7, 10)
    text += ["/&  ----------  END OF DATA  ----------"]
    channel = component.split("(")[0].split(":")[-1].replace("COMP", "").strip()
    step = STEP if width else None
    keep(name, text, kind, words, "g", step, None if width else times, scale=0.1, channel=channel)


def bhrc():
    words = [f".{abs(round(float(w) * 1e6)):06d}E+00" for w in wave(6, 0.9)]
    words = [("-" if float(w) < 0 else "") + word for w, word in zip(wave(6, 0.9), words)]
    text = ["* VOL1DS FILE:  0000/01", "Inst Type = SSA-2", "Origin Time : 2000/01/01   00:00:00", "", "L", ""]
    text += ["COMP L1", "Example                   Station   38.000 N 46.000 E   Altitude 1m   Azimuth L 177   T 267"]
    text += ["Epicenter", "INSTR PERIOD =  .020 SEC   DAMPING =  .640"]
    text += [f"NO. OF POINTS =  {COUNT:5d}      DURATION =  {COUNT * STEP:.3f}", "UNITS ARE SECONDS AND G/10", ""]
    text += rows(["0"] * 100, 5, 14) + rows(["0.199601E-01"] * 8 + [f"{RATE:.6E}"] + ["0.000000E+00"] * 41, 13, 8)
    text += rows(words, 13, 10) + ["END OF DATA"]
    keep("bhrc.V1", text, "BHRC", words, "g", scale=0.1, channel="L1")


def unam():
    channels = [wave(4, 5.0, 2.0), wave(4), wave(4, 11.0, 1.0)]
    text = ["*" * 60, "INSTITUTO EJEMPLO", "*" * 60, "ARCHIVO ESTANDAR DE ACELERACION:"]
    keys = {"VERSION DEL FORMATO": "2.0", "COORDENADAS DE LA ESTACION": "19.33024 LAT. N", "": "99.181 LONG. W"}
    keys |= {"INTERVALO DE MUESTREO, C1-C6 (s)": f"/{STEP}/{STEP}/{STEP}", "INTERVALO DE MUESTREO, C7-C12 (s)": ""}
    keys |= {"NUM. TOTAL DE MUESTRAS, C1-C6": f"/{COUNT}/{COUNT}/{COUNT}"}
    keys |= {"ACEL. MAX.(Gal), C1-C6": "".join(f"/{float(peak(c)):.2f}" for c in channels)}
    keys |= {"UNIDADES DE LOS DATOS": "Gal (cm/s/s)"}
    text += [f"{key:39}: {value}" for key, value in keys.items()]
    text += ["COMENTARIOS:", "", "DATOS DE ACELERACION:", "---------+---------+---------+"]
    text += ["   CANAL-1   CANAL-2   CANAL-3", "         V      N00E      N90E", "---------+---------+---------+"]
    text += ["".join(f"{word:>10}" for word in row) for row in zip(*channels)]
    keep("unam.txt", text, "UNAM", channels[1], "cm/s²", options={"column": "n00e"}, channel="N00E")


def afad():
    channels = [wave(6), wave(6, 12.0, 1.0), wave(6, 5.0, 2.0)]
    peaks = [f"{abs(float(peak(channel))):.6f}" for channel in channels]
    keys = {"PLACE": "EXAMPLE", "EARTHQUAKE DATE": "2020/01/01 00:00:00 (GMT)", "STATION COORDINATES": "37.8N-27.5E"}
    keys |= {"RECORD TIME": "01/01/2020 00:00:00.000000 (GMT)", "NUMBER OF DATA": COUNT, "SAMPLING INTERVAL (sec)": STEP}
    keys |= {"RAW PGA VALUES (gal)": "(N-S) {} (E-W) {} (U-D) {}".format(*peaks)}
    text = ["STRONG GROUND MOTION RECORDS OF TURKIYE"] + [f"{key:24}: {value}" for key, value in keys.items()]
    text += ["Copyright EARTHQUAKE DEPARTMENT", "DISASTER AND EMERGENCY MANAGEMENT PRESIDENCY"]
    text += ["       N-S          E-W          U-D"]
    text += ["".join(f"{word:>13}" for word in row) for row in zip(*channels)]
    keep("afad.txt", text, "AFAD", channels[1], "cm/s²", options={"column": "E-W"}, channel="E-W")


def trace(digits=4):
    data = np.array([float(word) for word in wave(digits)], dtype=np.float32)
    header = {"network": "XX", "station": "TEST", "location": "", "channel": "HNZ", "delta": STEP}
    header["starttime"] = obspy.UTCDateTime(2020, 1, 1)
    return obspy.Trace(data, header)


def sac():
    for order in ["<", ">"]:
        name = f"sac-{'little' if order == '<' else 'big'}.sac"
        made = trace()
        made.stats.sac = {"b": 0.5, "iftype": 1, "leven": 1}
        made.write(str(FOLDER / name), format="SAC", byteorder=order)
        read = obspy.read(str(FOLDER / name))[0]
        assert abs(read.stats.sac["b"] - 0.5) < 1e-6
        data = (FOLDER / name).read_bytes()
        keep(name, data, "SAC", read.data.tolist(), "g", options={"units": "g"}, channel="HNZ")
        FILES[name]["start"] = 0.5
    made = trace()
    made.write(str(FOLDER / "sac.txt"), format="SACXY")
    read = obspy.read(str(FOLDER / "sac.txt"), format="SACXY")[0]
    data = (FOLDER / "sac.txt").read_bytes()
    keep("sac.txt", data, "SAC", read.data.tolist(), "cm/s²", options={"units": "gal"}, channel="HNZ")
    # Single-precision samples in decimals.
    FILES["sac.txt"]["tolerance"] = 1e-6


def series():
    for kind in ["SLIST", "TSPAIR"]:
        made = trace()
        made.write(str(FOLDER / f"{kind.lower()}.txt"), format=kind)
        read = obspy.read(str(FOLDER / f"{kind.lower()}.txt"))[0]
        data = (FOLDER / f"{kind.lower()}.txt").read_bytes()
        name = f"{kind.lower()}.txt"
        keep(name, data, kind, read.data.tolist(), "cm/s²", options={"units": "gal"}, channel="XX_TEST__HNZ_")
        FILES[name]["tolerance"] = 1e-6


def deepsoil():
    words = wave(6, 0.3)
    text = [f"{COUNT} {STEP}"] + [f"{i * STEP:.2f} {word}" for i, word in enumerate(words)]
    keep("deepsoil.txt", text, "DEEPSOIL", words, "g")
    text = ["A title", f"{COUNT} {STEP}"] + rows(words, 11, 1)
    keep("count-and-step.txt", text, "count and step", words, "m/s²", options={"units": "m/s^2"})


def knet():
    counts = [str(round(float(word) * 1e4 + 4321)) for word in wave(4)]
    keys = {"Origin Time": "2000/01/01 00:00:00", "Lat.": "40.0", "Long.": "140.0", "Depth. (km)": "30", "Mag.": "6.0"}
    keys |= {"Station Code": "EXA001", "Station Lat.": "40.5", "Station Long.": "140.5", "Station Height(m)": "39"}
    keys |= {"Record Time": "2000/01/01 00:00:43", "Sampling Freq(Hz)": "1Hz", "Duration Time(s)": COUNT}
    keys |= {"Dir.": "E-W", "Scale Factor": "3920(gal)/6182761", "Max. Acc. (gal)": "0", "Last Correction": "", "Memo.": ""}
    factor = 3920 / 6182761
    values = np.array([int(count) for count in counts]) * factor
    keys["Max. Acc. (gal)"] = f"{abs(values - values.mean()).max():.3f}"
    keys["Last Correction"] = "2000/01/01 00:00:43"
    text = [f"{key:18}{value}" for key, value in keys.items()] + rows(counts, 9, 8)
    keep("knet.EW", text, "K-NET", counts, "cm/s²", 1.0, scale=factor, channel="E-W")
    read = obspy.read(str(FOLDER / "knet.EW"))[0]
    # ObsPy's samples are in m/s².
    ours = [float(count) * read.stats.calib for count in counts]
    assert np.allclose(read.data * read.stats.calib, ours, rtol=1e-12)
    assert abs(read.stats.calib * 100 / factor - 1) < 1e-6 and read.stats.delta == 1.0


FOLDER.mkdir(exist_ok=True)
smc()
csmip_v1()
csmip_v2()
even = [f"{i * STEP:.3f}" for i in range(COUNT)]
uneven = [f"{i * 0.0042857:.3f}" for i in range(COUNT)]
first = "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 01/01/2000"
max_of = "UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  =  {:.3f} G, AT   .360 SEC."
pairs("csmip-pairs.RAW", "CSMIP", first, 1, "CHAN  1:  90 DEG", max_of, even, True)
pairs("renadic.v1", "RENADIC", first, 7, "CHAN  1: L        (STA CHN:  1)", max_of, even, True)
usc = "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:"
pairs("usc.v1", "USC", usc, 1, "COMP N90E", "UNITS ARE SEC AND G/10", uneven, False)
bhrc()
unam()
afad()
sac()
series()
deepsoil()
knet()
(HERE / "layouts.json").write_text(json.dumps(FILES, indent=1, ensure_ascii=False) + "\n")
