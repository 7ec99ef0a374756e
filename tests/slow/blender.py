#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives clips to two programs that others wrote. Blender imports each as glTF binary, which the library
writes, and each BVH file itself; its frames, bones or objects, and their positions at up to 20 frames must
be those of the clip. The Khronos validator must find no error in the glTF file, and nothing to warn of or
hint at (its infos are that no mesh uses the skeleton or the points). Says which of the two is missing; exit
status 1 if a check fails, 2 if both are missing.

    tests/slow/blender.py [--build BUILD] [FILE...]    clips; default: the walker of the build

Needs a completed build in BUILD (default: build), NumPy, python3-cffi and python3-dev; for its checks
blender (Debian's package, 3.4) in the PATH, and node with the npm package gltf-validator, installed
globally or in the current directory.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

try:
    import bpy  # exists only inside Blender, which runs this file too
except ImportError:
    bpy = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
FARTHEST = 1e-5  # largest distance of a bone's head from its joint, over the largest coordinate
VALIDATE = """
const fs = require("fs");
let validator;
try { validator = require("gltf-validator"); } catch { process.exit(3); }
(async () => {
    const issues = {};
    for (const file of process.argv.slice(1))
        issues[file] = (await validator.validateBytes(fs.readFileSync(file))).issues;
    console.log(JSON.stringify(issues));
})();
"""


def placed(bvh):
    """Positions of bones, or of objects without bones, by name, with the y axis up again."""
    armatures = [thing for thing in bpy.data.objects if thing.type == "ARMATURE"]
    if armatures:
        heads = {bone.name: armatures[0].matrix_world @ bone.head
                 for bone in armatures[0].pose.bones}
    else:
        heads = {thing.name: thing.matrix_world.translation for thing in bpy.data.objects}
    return {name: list(head) if bvh else [head.x, head.z, -head.y] for name, head in heads.items()}


def import_file(path, fps, shown):
    """Runs in Blender: the number of keys, and the positions at these frames."""
    bpy.ops.wm.read_homefile(use_empty=True)
    bvh = path.endswith(".bvh")
    if bvh:
        bpy.ops.import_anim.bvh(filepath=path, axis_forward="Y", axis_up="Z")  # axes as in the file
    else:
        bpy.context.scene.render.fps = max(1, round(fps))
        bpy.context.scene.render.fps_base = bpy.context.scene.render.fps / fps
        bpy.ops.import_scene.gltf(filepath=path)
    keys = max(len(curve.keyframe_points) for action in bpy.data.actions
               for curve in action.fcurves)
    positions = []
    for frame in shown:
        bpy.context.scene.frame_set(frame + bvh)  # it puts the first frame of BVH at 1
        positions.append(placed(bvh))
    return {"frames": keys, "positions": positions}


def run_in_blender(arguments):
    import builtins
    import io_anim_bvh.import_bvh
    # The add-on opens files with mode "rU", which Python 3.11 no longer accepts.
    io_anim_bvh.import_bvh.open = lambda path, mode: builtins.open(path, "r")
    result, jobs = arguments
    found = [import_file(*job) for job in json.loads(pathlib.Path(jobs).read_text())]
    pathlib.Path(result).write_text(json.dumps(found))


def imported(folder, jobs):
    """What Blender makes of the files; None: it is not installed."""
    if shutil.which("blender") is None:
        return None
    result = folder / "result.json"
    (folder / "jobs.json").write_text(json.dumps(jobs))
    run = subprocess.run(
        ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
         str(pathlib.Path(__file__).resolve()), "--", str(result), str(folder / "jobs.json")],
        capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"blender failed:\n{run.stdout}{run.stderr}")
    return json.loads(result.read_text())


def validated(files):
    """What the validator says of each file; None: it is not installed."""
    if shutil.which("node") is None:
        return None
    everybodys = subprocess.run(["npm", "root", "--global"], capture_output=True, text=True,
                                check=False).stdout.strip() if shutil.which("npm") else ""
    paths = [everybodys, os.getcwd() + "/node_modules", os.environ.get("NODE_PATH", "")]
    run = subprocess.run(["node", "-e", VALIDATE, *files], capture_output=True, text=True,
                         env={**os.environ, "NODE_PATH": os.pathsep.join(filter(None, paths))})
    if run.returncode == 3:
        return None
    if run.returncode != 0:
        sys.exit(f"gltf-validator failed:\n{run.stdout}{run.stderr}")
    return json.loads(run.stdout)


def expected(clip, info, folder):
    """Names, and positions: frames x names x 3. Missing points have none (NaN)."""
    if clip.joints:
        return list(clip.joints), clip.positions
    clip.save(folder / "values.npy")  # the features fill gaps
    values, names = np.load(folder / "values.npy"), info["channels"]["names"]
    space = 3 if len(names) > 2 and names[2][-1] in "zZ" else 2
    return ([name[:-1].rstrip("_. :-") for name in names[::space]],
            np.pad(values.reshape(len(clip), -1, space), ((0, 0), (0, 0), (0, 3 - space))))


def agrees(what, names, positions, shown, seen):
    same = seen["frames"] == len(positions) and set(seen["positions"][0]) >= set(names)
    off = float("nan")
    if same:
        found = np.array([[at[name] for name in names] for at in seen["positions"]])
        off = np.nanmax(np.abs(found - positions[shown])) / np.nanmax(np.abs(positions))
    passed = bool(same and off <= FARTHEST)
    count = len(seen["positions"][0])
    print(f"Blender, {what}: {seen['frames']} of {len(positions)} frames, {count} of {len(names)} names, "
          f"distance {off:.1e}: {'pass' if passed else 'FAIL'}")
    return passed


def bones(clip, info, seen):
    """Blender's names of the joints of a BVH file that are not end sites, and their positions."""
    joints = [j for j, joint in enumerate(info["joints"]) if not joint["end_site"]]
    names = {name.lower(): name for name in seen["positions"][0]}
    found = [names.get(clip.joints[j].lower().replace(" ", "_"), clip.joints[j]) for j in joints]
    return (found if len(names) == len(joints) else ["another number of bones"]), clip.positions[:, joints]


def check(build, folder, path, clip, shown, seen, said):
    print(path)
    info = json.loads(subprocess.run([build / "tools" / "stltsa", "info", "--json", path],
                                     check=True, capture_output=True).stdout)
    passed = seen is None or agrees("glTF", *expected(clip, info, folder), shown, seen[0])
    if seen is not None and len(seen) > 1:
        passed = agrees("BVH", *bones(clip, info, seen[1]), shown, seen[1]) and passed
    if said is not None:
        clean = said["numErrors"] + said["numWarnings"] + said["numHints"] == 0
        for message in said["messages"][:3]:
            print(f"  {message['code']} {message.get('pointer', '')}: {message['message']}")
        print(f"gltf-validator: {said['numErrors']} errors, {said['numWarnings']} warnings, "
              f"{said['numInfos']} infos, {said['numHints']} hints: {'pass' if clean else 'FAIL'}")
        passed = passed and clean
    return passed


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path,
                        help="directory of a completed build (default: build)")
    parser.add_argument("files", nargs="*", metavar="FILE")
    options = parser.parse_args()
    files = options.files or [str(options.build / "tests" / "walker.bvh")]
    sys.path.insert(0, str(ROOT / "measure"))
    import measuring  # not inside Blender: its Python may lack the modules
    stltsa = measuring.binding(options.build)
    clips = [stltsa.read_clip(path) for path in files]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        jobs = []  # one for each clip, or two for BVH
        for i, clip in enumerate(clips):
            glb = str(folder / f"{i}.glb")
            clip.save(glb)
            shown = np.unique(np.linspace(0, len(clip) - 1, 20).astype(int)).tolist()
            own = [str(pathlib.Path(files[i]).resolve())] if files[i].endswith(".bvh") else []
            jobs.append([(file, clip.fps, shown) for file in [glb, *own]])
        found = imported(folder, [job for of_clip in jobs for job in of_clip])
        said = validated([of_clip[0][0] for of_clip in jobs])
        seen = found and iter(found)
        passed = [check(options.build, folder, path, clip, of_clip[0][2],
                        seen and [next(seen) for _ in of_clip], said and said[of_clip[0][0]])
                  for path, clip, of_clip in zip(files, clips, jobs)]
    if found is None:
        print("not checked: Blender is not installed (apt-get install blender)")
    if said is None:
        print("not checked: gltf-validator is not installed (npm install -g gltf-validator)")
    sys.exit(2 if found is None and said is None else 0 if all(passed) else 1)


if bpy is not None:
    run_in_blender(sys.argv[sys.argv.index("--") + 1:])
elif __name__ == "__main__":
    main()
