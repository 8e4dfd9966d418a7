"""How each command of the texts is run, in this order, and what it says that it would not say by chance."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Known:
    command: str  # as printed; `vnv` stands for build/vnv/vnv, too, and each that is printed is run
    says: str  # regular expression that fits somewhere in what it prints, and what `then` prints
    status: int = 0
    then: str = ""  # what is run after it in the same shell, to look at what it left
    first: str = ""  # what is run before it, in another
    needs: str = ""  # a program without which it is not run
    folder: str = "project"
    also: str = ""  # words that are added, for what would take the whole night else
    change: str = ""  # a file below vnv/trials that says what the last commit of the clone changes


HOLD = r"(\d+) of \1 methods hold, (\d+) of \2 claims"
ALL = r"(?P<held>\d+) of (?P=held) claims hold"
FORGET = "rm -rf build/records"  # or else what has been judged is skipped


def of_two(command, says, **more):
    """In a project of two cases, so that a suite takes seconds."""
    return Known(command, says, folder="two", **more)


BY_DAY = [
    Known("vnv --help", r"Usage: vnv .*\n(.*\n)*  explain +Explains"),
    Known("vnv list", r"dam_break\b"),
    Known("vnv list 'dam_*' --suite nightly", r"^dam_break .*\n  mpm\n    nightly +M1"),
    Known("vnv list 'dam_*.mpm' --suite nightly", r"^dam_break .*\n  mpm\n    nightly +M1"),
    Known("vnv list couette --json", '"case": ?"couette"'),
    Known("vnv plan --suite nightly -j 8", "dam_break.mpm"),
    Known("vnv plan 'invariance_*' --json", '"cpu": ?null'),
    Known("vnv plan mine.toml", r"stokes_first\.mine"),
    Known("vnv manual | man -l -", r"VNV\(1\)(.*\n)*.*vnv explain", needs="man"),
    Known("vnv explain dam_break.mpm", r"Martin & Moyce"),
    Known("vnv explain dam_break", "Martin & Moyce"),
    Known("vnv explain poiseuille.mpm", r"Morris, Fox & Zhu"),
    Known("vnv explain couette.mpm", "Morris, Fox & Zhu"),
    Known("source <(vnv completion bash)", "^poiseuille.mpm_reset$",
          then="COMP_WORDS=(vnv run poiseuille.mpm_res) COMP_CWORD=2; complete -p vnv && _vnv && printf '%s\\n' \"${COMPREPLY[@]}\""),
    Known("source <(vnv completion zsh)", "_vnv", then="typeset -f _vnv && echo ${_comps[vnv]}", needs="zsh"),
    Known("vnv/trials/faults/try.py --check --build build", "each fault fits"),
    Known("vnv scene", r"taylor_green"),
    Known("vnv scene poiseuille --set H=1 --set F=1e-5 --set nu=0.01", r"H = 1 m (.*\n)*body force: \(1e-05, 0\)"),
    Known("vnv scene taylor_green --spacing 0.02 --json --particles start.csv", r'"flow": ?"taylor_green"(.*\n)*2501 start.csv', then="wc -l start.csv"),
    Known("vnv judge --help", "Usage: vnv judge"),
    Known("vnv judge poiseuille --set H=1 --set F=1e-5 --set nu=0.01 out_40.vtp out_80.vtp out_160.vtp", r"observed order of L2 .*: 2\.0(.*\n)*" + ALL),
    Known("vnv judge poiseuille out.pvd --at-most 1", r"VTP(.*\n)*" + ALL),
    Known("vnv judge couette run_40.csv run_80.csv run_160.csv --unit length=mm", r"x, y in mm(.*\n)*observed order of L2 .*: 2\.0(.*\n)*" + ALL),
    Known("vnv judge poiseuille --set H=1 --set L=0.4 --set nu=0.01 --set F=1e-5 --only array=fluid --at-most 1 pysph_100.npz",
          r"NPZ of PySPH, 1000 particles at 20 s(.*\n)*" + ALL),
    Known("vnv judge taylor_green cells.vtu --set Re=100 --field velocity=U --axes xz --at-most 1", r"1600 cells at 0\.1 s(.*\n)*" + ALL),
    Known("vnv judge stokes_second plate.h5 --at-most 1 --diagnose", r"HDF5, 800 particles(.*\n)*.*FAILS; the flow is that of a fluid (1[5-9]|2[0-5])\S* ± [\d.]+ % too viscous", 1),
    Known("vnv order errors.csv", r"observed order 2\.00"),
    Known("vnv order errors.csv --surely-above 1.5", "all orders are surely above 1.5"),
    Known("vnv order drag.csv --values", r"extrapolated to 1\.99999"),
    Known("vnv run mine.toml", r"holds stokes_first\.mine: " + ALL),
    Known("vnv export stokes_first", r"verdicts\.tex", then="ls build/export/stokes_first"),
    Known('vnv prepare mine.toml runs && for run in runs/*/run.sh; do sbatch "$run"; done', r"(Submitted batch job \d+\n){3}"),
    Known("vnv collect mine.toml runs --records build/records/acceptance", ALL),
    Known("vnv gate old.toml new.toml", "10 worse, 0 inconclusive", 1),
    Known("vnv gate nights/monday nights/tuesday --json gate.json", r'10 worse, 0 inconclusive(.*\n)*.*"differences"', 1, then="cat gate.json",
          first="vnv run old.toml --records nights/monday && ! vnv run new.toml --records nights/tuesday"),
    Known("vnv export poiseuille", r"verdicts\.tex", then="ls build/export/poiseuille", first="vnv run poiseuille.mpm_least_squares"),
    Known("vnv export poiseuille --records mine --folder paper/poiseuille", r"verdicts\.tex", then="ls paper/poiseuille", first="cp -r build/records/acceptance mine"),
    Known("vnv report my_records my_site --history my_nights", r"my_site/index\.html(.*\n)*.*\.jsonl?", then="ls my_nights",
          first="cp -r build/records/acceptance my_records"),
    Known("build/vnv/stokes_first", r"stokes_first\.\w+ .*: HOLDS"),
    Known("stokes_first --method mpm --suite acceptance --records build/records", r"stokes_first\.mpm\.json", then="ls build/records"),
    of_two("vnv run --suite nightly -j 4", HOLD, first=FORGET),
    of_two("vnv report --suite nightly", r"build/site/nightly/index\.html"),
    of_two("touchstone_report build/records/nightly build/site/nightly --history nights", "build/site/nightly: 0 red"),
    of_two("vnv run 'invariance_*' --suite nightly -j 2", HOLD, first=FORGET),
    of_two("vnv run --suite nightly --engine parallel --hosts a,4/b", HOLD + r"(\n.*)*ssh [ab]$", first=FORGET, then='cat "$ASKED"'),
    of_two("vnv run --suite nightly --engine slurm --engine-option=--partition=long", HOLD + r"(\n.*)*sbatch .*--array=.*--partition=long", first=FORGET, then='cat "$ASKED"'),
    of_two("vnv run --engine slurm", HOLD + r"(\n.*)*sbatch .*--array=", first=FORGET, then='cat "$ASKED"'),
    of_two("vnv run --again --records mine", HOLD),
    of_two("vnv gate ../main/build build --markdown review.md", r"programs of 2 cases the same", then="cat review.md"),
]

UNITS = r"100% tests passed"
ACCEPTED = r"^couette.mpm: \d+ baselines changed$"
OLD = "echo {},old,1,0,0 >>data/claims/couette.csv"


def in_clone(command, says, **more):
    """In a clone of the sources, from nothing on."""
    return Known(command, says, folder="clone", **more)


BY_NIGHT = [
    in_clone("cmake --preset release", "Build files have been written to"),
    in_clone("cmake --build build --target vnv_command", "Linking CXX executable vnv/vnv"),
    in_clone("cmake --build build --target poiseuille", "Linking CXX executable vnv/poiseuille"),
    in_clone("vnv run poiseuille -j 2", HOLD),
    in_clone("vnv run poiseuille", HOLD + ".*7 skipped"),
    in_clone("cmake --build build --target check_headers", "vnv_headers"),
    in_clone("ctest -S .ci/nightly.cmake -V -DHISTORY=FOLDER", r"acceptance\.pages(.*\n)*100% tests passed", also=" '-DLABEL=^acceptance$'"),
    in_clone("ctest --test-dir build -L unit", UNITS),
    in_clone("vnv run couette.mpm", HOLD, first=FORGET),
    Known("ctest -R '^poiseuille.mpm$'", UNITS, folder="clone/build"),
    Known("ctest -L unit", UNITS, folder="clone/build"),
    in_clone("build/vnv/touchstone_bench", "plain_sph/dam/S4"),
    in_clone('RC_PARAMS="seed=7 max_success=2000" build/vnv/vnv_judge_test', r"OK, passed 2000 tests(.*\n)*\[  PASSED  \]"),
    in_clone('ctest -S .ci/nightly.cmake -V -DENGINE=slurm "-DENGINE_OPTIONS=--engine-option=--partition=long"',
             r"3 of 3 methods hold(.*\n)*.*nightly\.pages(.*\n)*sbatch .*--partition=long", also=" '-DLABEL=^stability$' -DMETHODS=invariance_cavity", then='cat "$ASKED"'),
    in_clone('vnv accept couette.mpm --reason "why the new values are right"', ACCEPTED + r"(.*\n)*# reason: why the new", then="head -5 data/baselines/couette.csv"),
    in_clone('vnv accept couette.mpm --reason "the wall moves with the fluid now: second order"', ACCEPTED),
    in_clone('vnv accept couette.old --suite nightly --claims build/records/nightly --reason "why there are fewer"', r"^couette.old: 1 claims, gone$",
             first=OLD.format("nightly")),
    in_clone('vnv accept couette.old --claims build/records/acceptance --reason "one method fewer"', r"^couette.old: 1 claims, gone$", first=OLD.format("acceptance")),
    in_clone('REASON="why the new values are right" cmake --build build --target accept_baselines', r"^[34]\d$", then="grep -l 'reason: why the new' data/baselines/*.csv | wc -l"),
    in_clone("cmake --preset portable && cmake --build build-portable --target vnv_command touchstone_report", "Linking CXX executable reports/touchstone_report"),
    in_clone("cmake --preset portable", "build-portable"),
    in_clone("cpack --config build-portable/CPackConfig.cmake", r"\.deb generated", then="dpkg-deb --contents *.deb", needs="dpkg-shlibdeps"),
    in_clone("cmake --workflow --preset sanitize", UNITS),
]
MORE_VISCOUS, SLOWER, RENAMED = "losses/more_viscous.fault", "losses/slower_by_a_tenth.fault", "faults/harmless/local_renamed.fault"
GATES = [  # of the last two commits of a clone
    in_clone("vnv gate HEAD~1 HEAD", r"^same\b.*: ", change=RENAMED, also=" --case couette"),
    in_clone("vnv gate HEAD~1 HEAD", r"^couette\.mpm .*L2 .*: worse: ", status=1, change=MORE_VISCOUS, also=" --case couette"),
    in_clone("vnv gate HEAD~1 HEAD", r"^couette\.mpm: user CPU time .*: worse: ", status=1, change=SLOWER, also=" --case couette"),
    in_clone("vnv gate HEAD~1 HEAD --case poiseuille --case couette", r"^same\b.*: ", change=RENAMED),
    in_clone("vnv gate HEAD~1 HEAD --markdown review.md", r"^same\b(.*\n)*\*\*same", change=RENAMED, then="cat review.md"),
    in_clone("vnv gate HEAD~1 HEAD", r"^same\b.*: ", change=RENAMED),
]
