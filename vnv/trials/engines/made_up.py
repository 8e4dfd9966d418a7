"""A build folder of made-up programs: what they judge they have read, after so many seconds, and they say when they ran."""

import json
import pathlib
import subprocess

PROGRAM = """#!/bin/sh
here=${0%/*} name=${0##*/}
case "$*" in *--describe*) exec cat "$here/$name.described" ;; esac
echo "$name.$2" >>"$here/../runs.txt"
sleep "$(cat "$here/../seconds")"
sed "s/@case@/$name/g; s/@method@/$2/g" "$here/record" >"$6/.$name.$2.part" && mv "$6/.$name.$2.part" "$6/$name.$2.json"
"""  # --method METHOD --suite SUITE --records FOLDER


class MadeUp:
    """Cases by name, each with so many methods that take as long; described and judged as a real one was."""

    def __init__(self, folder, program, record, cases, methods, seconds, relative_cost):
        self.folder, here = folder, folder / "vnv"
        here.mkdir(parents=True)
        (folder / "tables").mkdir()
        (folder / "seconds").write_text(f"{seconds}\n", encoding="utf-8")
        described = json.loads(subprocess.run([program, "--describe"], check=True, capture_output=True).stdout)
        method = {**described["methods"][0], "relative_cost": relative_cost}
        described.update(data_folder=str(folder / "tables"), baseline_file="", tables=[],
                         methods=[{**method, "name": f"m{k}"} for k in range(methods)])
        text = json.loads(pathlib.Path(record).read_text(encoding="utf-8"))
        case, of_method = text["case_name"], text["method"]
        text = json.dumps(text).replace(f'"{case}"', '"@case@"').replace(f'"{of_method}"', '"@method@"')
        (here / "record").write_text(text + "\n", encoding="utf-8")
        names = [f"case{k}" for k in range(cases)]
        for name in names:
            (here / f"{name}.described").write_text(json.dumps({**described, "name": name}), encoding="utf-8")
            (here / name).write_text(PROGRAM, encoding="utf-8")
            (here / name).chmod(0o755)
        (here / "cases.txt").write_text("\n".join(names) + "\n", encoding="utf-8")
        self.count = cases * methods

    def runs(self):
        """Names of methods, once for each start."""
        file = self.folder / "runs.txt"
        return file.read_text(encoding="utf-8").split() if file.exists() else []
