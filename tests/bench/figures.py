"""What the benchmarks share: errors of pictures, intervals, fits, and what is said about the machine."""

import math
import pathlib
import re
import statistics

NORMAL = statistics.NormalDist()


def machine():
    """The processor and its cores, in words."""
    text = pathlib.Path("/proc/cpuinfo").read_text()
    name = re.search(r"model name\s*: (.*)", text)
    return f"{name.group(1) if name else 'unknown processor'}, {text.count('processor')} cores"


def student_quantile(degrees, probability=0.975):
    """Wallace, "Bounds on normal approximations to Student's and the chi-square distributions", 1959; a little wide."""
    z = NORMAL.inv_cdf(probability) * (8 * degrees + 3) / (8 * degrees + 1)
    return math.sqrt(degrees * math.expm1(z * z / degrees))


def interval(values):
    """The mean, and the ends of its 95 % interval; nan where there is but one value."""
    mean = statistics.fmean(values)
    if len(values) < 2:
        return mean, math.nan, math.nan
    half = student_quantile(len(values) - 1) * statistics.stdev(values) / math.sqrt(len(values))
    return mean, mean - half, mean + half


def ratio_interval(pairs):
    """The geometric mean of ratios, and its 95 % interval."""
    return tuple(math.exp(x) for x in interval([math.log(a / b) for a, b in pairs]))


def slope_interval(xs, ys):
    """The exponent of y = a x^k, and the half width of its 95 % interval."""
    us, vs = [math.log(x) for x in xs], [math.log(y) for y in ys]
    fit = statistics.linear_regression(us, vs)
    mean = statistics.fmean(us)
    rest = sum((v - fit.intercept - fit.slope * u) ** 2 for u, v in zip(us, vs))
    degrees = len(us) - 2
    error = math.sqrt(rest / degrees / sum((u - mean) ** 2 for u in us))
    return fit.slope, student_quantile(degrees) * error


def squared_error(image, halves):
    """The mean squared error of a picture; two independent references, however noisy, add nothing to it."""
    return float(((image - halves[0]) * (image - halves[1])).mean())


def three_digits(x):
    """A number as the tables show it."""
    if x != x:
        return "?"
    return f"{x:.3g}" if x < 1000 else f"{x:.0f}"


def table(heads, rows):
    """Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join("|" + "|".join(str(cell) if cell == "---" else f" {cell} " for cell in line) + "|\n" for line in lines)
