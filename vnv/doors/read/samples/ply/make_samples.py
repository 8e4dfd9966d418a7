#!/usr/bin/env python3
"""Writes the samples of PLY: three particles as text and as bytes of both orders, in the layout of Turk (1994), as Taichi's PLYWriter has it."""

import pathlib
import struct

HERE = pathlib.Path(__file__).parent
ROWS = [(0.1, 0.2, 0, 1.5, -0.5, 0, 7), (0.3, 0.4, 0, 2.5, 0.25, 0, 8), (0.5, 0.6, 0, -3.5, 0.125, 0, 9)]
HEADER = """ply
format {} 1.0
comment created by PLYWriter
comment time 0.25
element vertex 3
property float x
property float y
property float z
property double vx
property double vy
property double vz
property uchar id
{}end_header
"""
FACE = "element face 1\nproperty list uchar int vertex_index\n"

(HERE / "ascii.ply").write_text(HEADER.format("ascii", FACE) + "".join(" ".join(map(str, row)) + "\n" for row in ROWS) + "3 0 1 2\n", encoding="ascii")
for name, order in (("little", "<"), ("big", ">")):
    rows = b"".join(struct.pack(order + "fffdddB", *row) for row in ROWS) + struct.pack(order + "Biii", 3, 0, 1, 2)
    (HERE / f"{name}_7.ply").write_bytes(HEADER.replace("comment time 0.25\n", "").format(f"binary_{name}_endian", FACE).encode("ascii") + rows)
