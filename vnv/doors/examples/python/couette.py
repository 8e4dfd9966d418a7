# SPDX-License-Identifier: MIT
"""Plane Couette flow by finite differences, judged at three resolutions."""

import touchstone

H, V, nu, L = 1.0, 0.1, 0.01, 0.5  # m, m/s, m²/s, m: between the plates, of the upper plate, of the fluid, of the periodic box


def samples(cells, until):
    """The velocity after each of the times `until` [s], at the middle of square cells, so many of them from plate to plate."""
    dy, time, u = H / cells, 0.0, [0.0] * cells
    for end in until:
        while time < end:
            dt = min(0.25 * dy * dy / nu, end - time)
            around = [-u[0], *u, 2 * V - u[-1]]  # no slip at both plates
            u = [u[k] + dt * nu * (around[k] - 2 * u[k] + around[k + 2]) / dy**2 for k in range(cells)]
            time += dt
        rows = [(k + 0.5) * dy for k in range(cells)]
        columns = [(k + 0.5) * dy for k in range(round(L / dy))]
        yield {
            "t": end,
            "x": [x for _ in rows for x in columns],
            "y": [y for y in rows for _ in columns],
            "v_x": [v for v in u for _ in columns],
            "v_y": [0.0] * (cells * len(columns)),
        }


couette = touchstone.flow("couette", H=H, V=V, nu=nu, L=L)
verdict = couette.judge((sample for cells in (10, 20, 40) for sample in samples(cells, (5, 20))), at_most=1, name="differences")
print(verdict)
raise SystemExit(0 if verdict else 1)
