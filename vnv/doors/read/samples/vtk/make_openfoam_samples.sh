#!/bin/bash
# usage: make_openfoam_samples.sh FOLDER    writes openfoam/ there: four by four cells of a lid-driven cavity, with icoFoam and foamToVTK of OpenFOAM v1912
set -e
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
folder=$(realpath "$1") && case=$(mktemp -d)/cavity && mkdir -p "$case"/0 "$case"/constant "$case"/system && cd "$case"
dictionary() { echo "FoamFile { version 2.0; format ascii; class $1; object $(basename "$2"); } $3" > "$2"; }
dictionary dictionary system/blockMeshDict 'scale 0.1;
  vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 0.1) (1 0 0.1) (1 1 0.1) (0 1 0.1)); blocks (hex (0 1 2 3 4 5 6 7) (4 4 1) simpleGrading (1 1 1));
  boundary (lid { type wall; faces ((3 7 6 2)); } walls { type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0)); } sides { type empty; faces ((0 3 2 1) (4 5 6 7)); });'
dictionary dictionary system/controlDict 'startFrom startTime; startTime 0; stopAt endTime; endTime 0.02; deltaT 0.005; writeControl timeStep; writeInterval 2; writePrecision 12;'
dictionary dictionary system/fvSchemes 'ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { div(phi,U) Gauss linear; }
  laplacianSchemes { default Gauss linear orthogonal; } interpolationSchemes { default linear; } snGradSchemes { default orthogonal; }'
dictionary dictionary system/fvSolution 'solvers { p { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0; } pFinal { $p; } U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-5; relTol 0; } }
  PISO { nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }'
dictionary dictionary constant/transportProperties 'nu 0.01;'
dictionary volVectorField 0/U 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
  boundaryField { lid { type fixedValue; value uniform (1 0 0); } walls { type noSlip; } sides { type empty; } }'
dictionary volScalarField 0/p 'dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField { lid { type zeroGradient; } walls { type zeroGradient; } sides { type empty; } }'
blockMesh > log.blockMesh
icoFoam > log.icoFoam
foamToVTK -time 0.01:0.02 -name xml > log.xml
foamToVTK -time 0.01:0.02 -name xml_ascii -ascii -no-boundary > log.xml_ascii
foamToVTK -time 0.01:0.02 -name legacy -legacy -no-boundary > log.legacy
foamToVTK -time 0.01:0.02 -name legacy_ascii -legacy -ascii -no-boundary > log.legacy_ascii
rm -rf "$folder/openfoam" && mkdir "$folder/openfoam" && mv xml xml_ascii legacy legacy_ascii "$folder/openfoam"
