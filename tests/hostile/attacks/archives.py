"""Archives, and which of several files is the fragment."""

import gzip
import io
import os
import tarfile

from .kit import MIRROR, NO_FILE, case, disk, victim_is_whole, zipped

MIB = 1 << 20


@case("31a", "an archive whose names lead out of it", "passed", after=victim_is_whole, fast=True)
def _(place):
    return zipped(place, [("fragments/uniform_disk.cpp", disk("    return right(u);")), (f"{place.victim}/zip", "x"),
                          (f"../../../../../..{place.victim}/zip", "x"), ("../uniform_disk.cpp", disk("    return wrong(u);"))])


@case("31b", "an archive with links and devices", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    path = place.folder / "submission.tar.gz"
    with tarfile.open(path, "w:gz") as archive:
        link = tarfile.TarInfo("fragments/uniform_disk.cpp")
        link.type, link.linkname = tarfile.SYMTYPE, str(place.root / "solution/uniform_disk.cpp")
        archive.addfile(link)
        device = tarfile.TarInfo("fragments/mirror_direction.cpp")
        device.type, device.devmajor, device.devminor = tarfile.CHRTYPE, 1, 5
        archive.addfile(device)
        file = tarfile.TarInfo("fragments/phong.cpp")
        file.size = len(MIRROR)
        archive.addfile(file, io.BytesIO(MIRROR.encode()))
    return path


@case("31c", "an archive that unpacks to 300 MB", "passed", "unpacks to more than")
def _(place):
    return zipped(place, [("fragments/uniform_disk.cpp", disk("    return right(u);")), ("big", bytes(300 * MIB))])


@case("31d", "a fragment of 300 MB in an archive", {"did_not_build", "not_started"}, "larger than", fast=True)
def _(place):
    return zipped(place, [("fragments/uniform_disk.cpp", bytes(300 * MIB)), ("fragments/phong.cpp", "x")])


@case("31e", "no archive at all", set(), "cannot be unpacked", code=2)
def _(place):
    path = place.folder / "submission.tar.gz"
    path.write_bytes(gzip.compress(b"\xff" * 5000)[:-9] + b"\0" * 20)
    return path


@case("45a", "an archive of 6,000 copies", {"passed", "failed"}, code=None)
def _(place):
    filler = os.urandom(16 << 10).hex()
    return zipped(place, [(f"copy{i}/uniform_disk.cpp", disk("    return right(u);") + f"// {i} " + filler * 6) for i in range(1500)]
                  + [(f"more{i}/uniform_disk.cpp", f"// {i}\n" + " " * 250_000) for i in range(4500)])


case("45b", "names that look like fragments", "not_started", "uniform_disk", own=True,
     source={"fragments/Uniform_Disk.cpp": disk("    return right(u);"), "fragments/uniform_disk-1.cpp": "x", "fragments/uniform_disk.cpp.txt": "x",
             "fragments/uniform_disk.cpp/uniform_disk.txt": "x", "fragments/phong.cpp": "x"})


@case("45c", "UTF-8 names in an archive, with and without the flag", "passed")
def _(place):
    path = zipped(place, [("\u00dcbung \u4e00/fragments/uniform_disk.cpp", disk("    return right(u);")), ("caf\u00e9/readme.txt", "x")])
    data = bytearray(path.read_bytes())
    for signature, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):  # one of two entries loses the flag
        data[data.rindex(signature) + at + 1] &= ~0x08 & 0xff
    path.write_bytes(data)
    return path


case("45d", "two copies of the assignment", "passed", "taken", own=True,
     source={"old/fragments/uniform_disk.cpp": disk("    return wrong(u);"), "new/fragments/uniform_disk.cpp": disk("    return right(u);"),
             "new/fragments/mirror_direction.cpp": MIRROR})
