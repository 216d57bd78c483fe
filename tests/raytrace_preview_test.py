#!/usr/bin/env python3
"""raytrace --preview draws into the terminal, in its place, and leaves the terminal as it was.

    raytrace_preview_test.py RAYTRACE    0: it does; 77: there is no tmux
"""

import os
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

from helpers import end, expect, skip

SCENE = "scenes/gallery/cornell.toml"


class Screen:
    """A terminal of so many columns and rows, with a shell in it."""

    def __init__(self, columns, rows):
        self.socket = tempfile.mkdtemp()
        self.tmux("-f", "/dev/null", "new-session", "-d", "-x", str(columns), "-y", str(rows), "env PS1='$ ' sh")
        self.wait(r"^\$")

    def tmux(self, *words):
        command = ["tmux", "-S", f"{self.socket}/tmux", *words]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    def type(self, *keys):
        self.tmux("send-keys", *keys)

    def text(self, *options):
        return self.tmux("capture-pane", "-p", *options)

    def wait(self, pattern, seconds=20):
        """Waits until the screen shows the pattern; returns the text."""
        end = time.monotonic() + seconds
        while True:
            text = self.text()
            seen = re.search(pattern, text.rstrip("\n"), re.M)
            if seen or time.monotonic() > end:
                expect(seen, f"never saw {pattern!r} in:\n{text}")
                return text
            time.sleep(0.05)

    def close(self):
        self.tmux("kill-server")
        shutil.rmtree(self.socket)


def picture_lines(text):
    return [line for line in text.splitlines() if "\u2580" in line]


def in_tmux(raytrace):
    """Half blocks, for tmux has neither kitty's protocol nor sixels."""
    for columns, rows in [(80, 24), (30, 40)]:
        screen = Screen(columns, rows)
        screen.type(f"{raytrace} {SCENE} --preview --time-limit 2", "Enter")
        during = screen.wait(r"\] +[1-9]\d* %", 5)
        after = screen.wait(r"^hash ")
        lines = picture_lines(after)
        size = min(columns, 2 * (rows - 2))  # the scene is a square
        for name, text in [("during", during), ("after", after)]:
            widths = {len(line) for line in picture_lines(text)}
            expect(max(widths) == size, f"{name}: lines of {widths}; expected {size}")
        history = picture_lines(screen.text("-S", "-"))
        expect(len(history) == size // 2, f"{columns} x {rows}: {len(history)} lines of picture in all; expected {size // 2}")
        expect(len(lines) >= size // 2 - 8, f"{len(lines)} lines of picture are left")
        expect("%" not in after, "the bar is left")
        colors = set(re.findall(r"38;2;(\d+);(\d+);(\d+)", screen.text("-e", "-S", "-")))
        expect(len(colors) > 100, f"only {len(colors)} colours")
        expect(screen.tmux("display", "-p", "#{cursor_flag}").strip() == "1", "the cursor is gone")
        screen.close()


def interrupted(raytrace):
    screen = Screen(80, 24)
    screen.type(f"{raytrace} {SCENE} --preview --time-limit 60", "Enter")
    screen.wait(r"\] +\d+ %")
    screen.type("C-c")
    after = screen.wait(r"^hash ")
    expect(len(picture_lines(after)) > 10, f"Ctrl-C left no picture:\n{after}")
    expect(screen.tmux("display", "-p", "#{cursor_flag}").strip() == "1", "the cursor is gone after Ctrl-C")
    screen.type("echo it's $((6 * 7)) | tr \"'\" _; stty -a | tr ' ' '\\n' | grep -x echo".replace("it's", "it"), "Enter")
    screen.wait(r"^(\$ )?it 42")
    screen.wait(r"^echo$")
    screen.close()


def on_terminal(command, answer=b""):
    """What a program writes to a terminal that answers its question; and how long it took."""
    child, terminal = pty.fork()
    if child == 0:
        os.environ["TERM"] = "xterm-256color"
        os.execv(command[0], command)
    said, start = b"", time.monotonic()
    while time.monotonic() < start + 30:
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            piece = os.read(terminal, 65536)
        except OSError:
            break
        said += piece
        if b"\x1b[c" in piece and answer:
            os.write(terminal, answer)
    os.waitpid(child, 0)
    os.close(terminal)
    return said, time.monotonic() - start


def protocols(raytrace):
    command = [raytrace, SCENE, "--preview", "--size", "40x40", "--samples", "2"]
    said, _ = on_terminal(command, b"\x1b_Gi=31;OK\x1b\\\x1b[?62;c")
    expect(b"\x1b_Ga=T,f=100" in said and b"\xe2\x96\x80" not in said, "a terminal that knows kitty's protocol gets no picture")
    said, _ = on_terminal(command, b"\x1b[?62;4;22c")
    expect(b"\x1bP0;1;0q" in said and b"\xe2\x96\x80" not in said, "a terminal that knows sixels gets none")
    said, _ = on_terminal(command, b"\x1b[?1;2c")
    expect(b"\xe2\x96\x80" in said, "a terminal without pixels gets no half blocks")
    said, seconds = on_terminal(command)
    expect(b"\xe2\x96\x80" in said and seconds < 5, f"a terminal that does not answer: {seconds} s")
    expect(b"hash" in said, "no report")
    for kind, sign in [("kitty", b"\x1b_Ga=T"), ("sixel", b"\x1bP0;1;0q"), ("blocks", b"\xe2\x96\x80")]:
        said, _ = on_terminal([raytrace, SCENE, f"--preview={kind}", "--size", "40x40", "--samples", "2"])
        expect(sign in said and b"\x1b[c" not in said, f"--preview={kind} does not do so, or asks")


def into_pipes(raytrace):
    done = subprocess.run([raytrace, SCENE, "--preview", "--size", "20x20", "--samples", "2"], capture_output=True, check=False)
    expect(done.returncode == 0 and b"\x1b" not in done.stdout + done.stderr, "a pipe is garbled")
    expect(b"--preview: " in done.stderr, "no word that there is no terminal")


def main():
    if not shutil.which("tmux"):
        skip("tmux is missing: nothing is tested; apt-get install tmux")
    raytrace = os.path.abspath(sys.argv[1])
    into_pipes(raytrace)
    protocols(raytrace)
    in_tmux(raytrace)
    interrupted(raytrace)
    end("pictures are drawn into the terminal")


if __name__ == "__main__":
    main()
