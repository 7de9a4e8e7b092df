"""A display for a program: the machine's own, or a virtual one for as long as the program runs."""

import contextlib
import os
import select
import shutil
import subprocess
import sys

from .place import Missing

REMEDY = "Install Xvfb (Debian: apt install xvfb; pacman -S xorg-server-xvfb), or run where a display is."


def has_display():
    return not sys.platform.startswith("linux") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


@contextlib.contextmanager
def virtual(width, height, window_manager=False):
    """The environment of a virtual display on a free number; it ends with the block. Elsewhere than on Linux, the own."""
    if not sys.platform.startswith("linux"):
        yield dict(os.environ)
        return
    server = shutil.which("Xvfb")
    if not server:
        raise Missing(f"There is no display, and no Xvfb to make one.\n{REMEDY}")
    reader, writer = os.pipe()
    words = [server, "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp", "-noreset"]
    process = subprocess.Popen(words, pass_fds=[writer], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    os.close(writer)
    others = []
    try:
        number = read_line(reader, seconds=30)
        if not number:
            raise Missing(f"Xvfb ({server}) did not start.\n{REMEDY}")
        environment = {**os.environ, "DISPLAY": f":{number}"}
        environment.pop("WAYLAND_DISPLAY", None)
        manager = shutil.which("matchbox-window-manager") if window_manager else None
        if manager:
            others.append(subprocess.Popen([manager], env=environment, stdin=subprocess.DEVNULL,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        yield environment
    finally:
        os.close(reader)
        for program in (*others, process):
            stop(program)


def read_line(reader, seconds):
    """One line from a pipe; empty if it ends or stays silent."""
    line = b""
    while not line.endswith(b"\n"):
        if not select.select([reader], [], [], seconds)[0]:
            return ""
        byte = os.read(reader, 16)
        if not byte:
            return ""
        line += byte
    return line.decode().strip()


def stop(process):
    process.terminate()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
