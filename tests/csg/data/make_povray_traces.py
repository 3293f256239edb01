#!/usr/bin/env python3
"""Writes povray_traces.csv beside itself: what the real POV-Ray's trace() answers for rays at objects of ours.

Needs `povray` 3.7 in the PATH. Columns: object, ray origin, ray direction (not normalised), hit point, raw normal; a miss
has a normal of <0,0,0>. The objects are built again in povray_test.cpp, by the same names.
"""
import pathlib
import random
import subprocess
import tempfile

OBJECTS = {
    "sphere": "sphere{<0.2,0.1,-0.3>,0.9}",
    "ellipsoid": "sphere{0,1 scale <1,0.5,1.5> rotate <30,40,50>}",
    "box": "box{<-1,-0.5,-0.7>,<1,0.5,0.8>}",
    "oriented_box": "box{<-1,-0.5,-0.7>,<1,0.5,0.8> rotate <30,40,50>}",
    "cylinder": "cylinder{<-0.5,-1,0.2>,<0.5,1,0>,0.6}",
    "open_cylinder": "cylinder{-y,y,0.7 open}",
    "cone": "cone{<0,-1,0>,1,<0.2,1,0>,0.3}",
    "double_cone": "cone{0,1,2*y,-0.5}",
    "torus": "torus{1,0.25}",
    "moved_torus": "torus{1,0.4 scale <1,0.7,1.3> rotate <30,40,50> translate <0.1,-0.2,0.3>}",
    "spindle": "torus{0.5,0.8}",
    "quadric": "quadric{<1,2,4>,<0.3,-0.2,0.1>,<-0.5,0.2,0>,-1}",
    "hyperboloid": "quadric{<1,1,-1>,<0,0,0>,<0,0,0>,-0.1}",
    "disc": "disc{<0.1,0,0>,<1,1,0>,1,0.3}",
    "difference": "difference{box{-1,1} sphere{<0.5,0.5,-1>,0.9} cylinder{-2*x,2*x,0.4} plane{y,-0.6}}",
    "intersection": "intersection{sphere{0,1} box{<-0.8,-0.7,-0.6>,<0.9,0.8,0.7>} torus{0.6,0.5}}",
    "merge": "merge{sphere{-0.3*x,0.8} box{<0,-0.5,-0.5>,<1.2,0.5,0.5>} cone{-y,0.7,y,0.1}}",
    "nested": "difference{merge{sphere{0,1} torus{0.9,0.4}} union{cylinder{-2*y,2*y,0.4} intersection{box{<0,-1,-2>,<2,0.2,2>} "
              "sphere{0.5*x,0.9}}}}",
    "clipped": "object{sphere{0,1} clipped_by{plane{z,0.1} box{<-2,-0.5,-2>,<2,0.9,2>}}}",
    "inverse_union": "union{sphere{0,1} sphere{0.7*x,0.8} inverse}",
}
RAYS = 40


def main():
    random.seed(20240611)
    lines = ["#version 3.7;", "global_settings{assumed_gamma 1}", "#fopen OUT \"rows.csv\" write"]
    for name, text in OBJECTS.items():
        lines.append(f"#declare OB={text}")
        for _ in range(RAYS):
            origin = [random.uniform(-4, 4) for _ in range(3)]
            target = [random.uniform(-0.9, 0.9) for _ in range(3)]
            o = [f"{v:.6f}" for v in origin]
            d = [f"{t - float(v):.6f}" for t, v in zip(target, o)]
            lines.append(f"#declare N=<0,0,0>;#declare H=trace(OB,<{','.join(o)}>,<{','.join(d)}>,N);")
            lines.append(f'#write(OUT,concat("{name},{",".join(o)},{",".join(d)},",vstr(3,H,",",0,12),",",'
                         'vstr(3,N,",",0,12),"\\n"))')
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder, "trace.pov")
        scene.write_text("\n".join(lines) + "\n")
        run = subprocess.run(["povray", f"+I{scene}", f"+O{folder}/trace.png", "+W1", "+H1", "-D", "+GD"], capture_output=True,
                             text=True, check=False, cwd=folder)
        written = pathlib.Path(folder, "rows.csv")
        rows = written.read_text().splitlines() if written.exists() else []
    if len(rows) != RAYS * len(OBJECTS):
        raise SystemExit(f"expected {RAYS * len(OBJECTS)} rows, got {len(rows)}:\n{run.stderr[-2000:]}")
    out = pathlib.Path(__file__).with_name("povray_traces.csv")
    out.write_text("object,ox,oy,oz,dx,dy,dz,px,py,pz,nx,ny,nz\n" + "\n".join(rows) + "\n")


main()
