#!/usr/bin/env python3
"""Runs OpenFOAM (interFoam: volume of fluid, laminar) on the scene in this folder, water that falls in air; VTK/ has what it wrote.

run_interfoam.py COURANT: the largest Courant number. The air is that of 20 °C, there is no surface tension, and a side without a wall is
open to air at rest, whose pressure is zero.
"""

import sys

from run_openfoam import at_side, every_time, mesh, patches, read_scene, run, write


def fraction_filled(scene, columns, rows):
    """Of each cell, along x first, then along y: the part of it that lies in the box of water."""
    def along(axis, count):
        low, high = (scene["domain"][end][axis] for end in ("low [m]", "high [m]"))
        first, last = (scene["filled"][end][axis] for end in ("low [m]", "high [m]"))
        side = (high - low) / count
        return [max(0, min(last, low + (k + 1) * side) - max(first, low + k * side)) / side for k in range(count)]
    return [of_row * of_column for of_row in along(1, rows) for of_column in along(0, columns)]


def field(scene, name, kind, dimensions, inside, at_wall, at_opening):
    sides = "".join(f"{side} {{ {at_wall(wall) if wall else at_opening} }}\n" for side, wall in patches(scene).items())
    write("0/" + name, kind, f"""dimensions [{dimensions}];
internalField {inside};
boundaryField {{ {sides} frontAndBack {{ type empty; }} }}""")


def fields(scene, columns, rows):
    water = " ".join(f"{fraction:.12g}" for fraction in fraction_filled(scene, columns, rows))
    field(scene, "alpha.water", "volScalarField", "0 0 0 0 0 0 0", f"nonuniform List<scalar> {columns * rows} ({water})",
          lambda _: "type zeroGradient;", "type inletOutlet; inletValue uniform 0; value uniform 0;")
    field(scene, "U", "volVectorField", "0 1 -1 0 0 0 0", "uniform (0 0 0)", at_side, "type pressureInletOutletVelocity; value uniform (0 0 0);")
    field(scene, "p_rgh", "volScalarField", "1 -1 -2 0 0 0 0", "uniform 0",
          lambda _: "type fixedFluxPressure; value uniform 0;", "type totalPressure; p0 uniform 0; value uniform 0;")
    # Not read; so that all times have the field. Particles start without pressure, too.
    field(scene, "p", "volScalarField", "1 -1 -2 0 0 0 0", "uniform 0", lambda _: "type calculated; value uniform 0;", "type calculated; value uniform 0;")


def settings(scene, courant):
    rho = scene["fluid"]["density [kg/m³]"]
    write("constant/transportProperties", "dictionary", f"""phases (water air); sigma 0;
water {{ transportModel Newtonian; nu {scene["fluid"]["viscosity [Pa s]"] / rho!r}; rho {rho!r}; }}
air {{ transportModel Newtonian; nu 1.5e-5; rho 1.2; }}""")
    write("constant/turbulenceProperties", "dictionary", "simulationType laminar;")
    (g_x, g_y) = scene["body force"]["amplitude [m/s²]"]
    write("constant/g", "uniformDimensionedVectorField", f"dimensions [0 1 -2 0 0 0 0]; value ({g_x} {g_y} 0);")
    write("constant/hRef", "uniformDimensionedScalarField", f"dimensions [0 1 0 0 0 0 0]; value {scene['domain']['high [m]'][1]!r};")
    write("system/fvSchemes", "dictionary", """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes
{ div(rhoPhi,U) Gauss linearUpwind grad(U); div(phi,alpha) Gauss vanLeer; div(phirb,alpha) Gauss linear;
  div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }""")
    write("system/fvSolution", "dictionary", """solvers
{ "alpha.water.*" { nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5; solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0; }
  "(p_rgh|pcorr).*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.01; }
  p_rghFinal { $p_rgh; relTol 0; }
  "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; } }
PIMPLE { momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }""")
    interval = every_time(scene)
    write("system/controlDict", "dictionary", f"""application interFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime {scene["times [s]"][-1]!r}; deltaT 1e-4; adjustTimeStep yes; maxCo {courant!r}; maxAlphaCo {courant!r}; maxDeltaT {interval!r};
writeControl adjustableRunTime; writeInterval {interval!r}; writeFormat binary; writePrecision 12; timePrecision 10; runTimeModifiable no;""")


def main(courant):
    scene = read_scene()
    spacing = scene["spacing [m]"]
    columns, rows = (round((high - low) / spacing) for low, high in zip(scene["domain"]["low [m]"], scene["domain"]["high [m]"]))
    mesh(scene, columns, rows, 1)  # m  deep: volumes are judged per metre
    fields(scene, columns, rows)
    settings(scene, courant)
    run("blockMesh")
    run("interFoam")
    run("foamToVTK", "-no-boundary", "-fields", "(U p alpha.water)")


if __name__ == "__main__":
    main(float(sys.argv[1]))
