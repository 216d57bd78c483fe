#!/usr/bin/env python3
"""Pictures that raytrace sends to tev arrive, piece by piece, and at last are those of its own file.

    raytrace_tev_test.py RAYTRACE    0: they do
"""

import pathlib
import re
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import zlib

from helpers import end, expect

CREATE, UPDATE = 4, 6


class Packet:
    """What is left to read of a message."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, form):
        values = struct.unpack_from("<" + form, self.data, self.at)
        self.at += struct.calcsize("<" + form)
        return values if len(values) > 1 else values[0]

    def text(self):
        end = self.data.index(0, self.at)
        text, self.at = self.data[self.at : end].decode(), end + 1
        return text


class Viewer(threading.Thread):
    """Takes tev's place: one connection, one picture."""

    def __init__(self, deaf_after=None):
        super().__init__(daemon=True)
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.creations, self.updates, self.pixels, self.faults = [], 0, {}, []
        self.deaf_after = deaf_after
        self.start()

    def run(self):
        connection, _ = self.server.accept()
        with connection:
            while size := self.receive(connection, 4):
                (length,) = struct.unpack("<I", size)
                self.understand(Packet(self.receive(connection, length - 4)))
                if self.deaf_after is not None and self.updates > self.deaf_after:
                    return

    @staticmethod
    def receive(connection, count):
        data = b""
        while len(data) < count:
            piece = connection.recv(count - len(data))
            if not piece:
                return b""
            data += piece
        return data

    def understand(self, packet):
        kind, grab = packet.take("BB")
        name = packet.text()
        if kind == CREATE:
            width, height, count = packet.take("3i")
            self.creations.append((name, width, height, [packet.text() for _ in range(count)], grab))
        elif kind == UPDATE:
            count = packet.take("i")
            channels = [packet.text() for _ in range(count)]
            x, y, width, height = packet.take("4i")
            offsets, strides = packet.take(f"{count}q"), packet.take(f"{count}q")
            values = packet.take(f"{(len(packet.data) - packet.at) // 4}f")
            if channels != ["R", "G", "B"] or len(values) != 3 * width * height:
                self.faults.append(f"an update of {channels}, {len(values)} values for {width} x {height}")
            for k in range(width * height):
                pixel = tuple(values[o + s * k] for o, s in zip(offsets, strides))
                self.pixels[x + k % width, y + k // width] = pixel
            self.updates += 1
        else:
            self.faults.append(f"a message of kind {kind}")
        if packet.at != len(packet.data):
            self.faults.append(f"{len(packet.data) - packet.at} bytes too many in a message of kind {kind}")


def exr_pixels(path):
    """The pixels of an EXR file as raytrace writes it, by their place in the film: scan lines, floats, deflated."""
    data = path.read_bytes()
    at, attributes = 8, {}
    while data[at]:
        name_end = data.index(0, at)
        kind_end = data.index(0, name_end + 1)
        (size,) = struct.unpack_from("<i", data, kind_end + 1)
        attributes[data[at:name_end].decode()] = data[kind_end + 5 : kind_end + 5 + size]
        at = kind_end + 5 + size
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, pixels = right - left + 1, {}
    blocks = (bottom - top) // 16 + 1
    for offset in struct.unpack_from(f"<{blocks}Q", data, at + 1):
        y, size = struct.unpack_from("<2i", data, offset)
        rows = min(16, bottom - y + 1)
        packed = data[offset + 8 : offset + 8 + size]
        raw = packed
        if size < rows * width * 12:
            difference = bytearray(zlib.decompress(packed))
            for k in range(1, len(difference)):
                difference[k] = (difference[k - 1] + difference[k] - 128) & 0xFF
            half = (len(difference) + 1) // 2
            raw = bytearray(len(difference))
            raw[0::2], raw[1::2] = difference[:half], difference[half:]
        for row in range(rows):
            blue, green, red = (
                struct.unpack_from(f"<{width}f", raw, (3 * row + channel) * width * 4) for channel in range(3)
            )
            for x in range(width):
                pixels[left + x, y + row] = (red[x], green[x], blue[x])
    return attributes, pixels


def render(raytrace, viewer, out, *options):
    command = [raytrace, "scenes/gallery/cornell.toml", "-o", out, "--tev", f"127.0.0.1:{viewer.port}", *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    expect(done.returncode == 0, f"{command}: exit {done.returncode}: {done.stderr}")
    return done


def main():
    raytrace = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "a.exr"
        for options, film in [
            (["--size", "70x50", "--time-limit", "1.5"], (70, 50)),
            (["--size", "70x50", "--samples", "4", "--crop", "8,9,30,20"], (70, 50)),
            (["--size", "600x500", "--samples", "1"], (600, 500)),
        ]:
            viewer = Viewer()
            render(raytrace, viewer, out, *options)
            viewer.join(10)
            attributes, pixels = exr_pixels(out)
            expect(viewer.faults == [], f"{options}: {viewer.faults}")
            expect(viewer.creations == [(str(out), *film, ["R", "G", "B"], 1)], f"{options}: created {viewer.creations}")
            expect(viewer.pixels == pixels, f"{options}: tev shows another picture than the file holds")
            expect(
                struct.unpack("<4i", attributes["displayWindow"]) == (0, 0, film[0] - 1, film[1] - 1),
                f"{options}: the display window is not the film",
            )
            if "--time-limit" in options:
                expect(3 <= viewer.updates <= 20, f"{viewer.updates} updates in 1.5 s; expected a few in each second")

        viewer = Viewer(deaf_after=0)
        done = render(raytrace, viewer, out, "--size", "70x50", "--time-limit", "3")
        expect(re.search("--tev: tev at .* has gone: .*; the picture is complete without", done.stderr), done.stderr)
        expect("70 x 50 pixels" in done.stdout, "tev went away, and with it the picture")
    end("pictures arrive at tev")


if __name__ == "__main__":
    main()
