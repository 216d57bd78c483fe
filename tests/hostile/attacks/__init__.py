"""The submissions of the red team, by what they attack."""

from . import answers, archives, compiler, endings, files, linker, others, sources, told  # noqa: F401
from .kit import cases

cases.sort(key=lambda case: (int(case.kind), case.number))
