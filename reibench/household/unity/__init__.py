"""The wire stand-in: the embedded simulator behind AI2-THOR 5's own protocols, FIFO and WSGI.

    build = f"{sys.executable} -m reibench.household.unity"
    Controller(local_executable_path=build, x_display=":0")

With it the unmodified `ai2thor.controller.Controller` runs without Unity, display or download.
What it answers is the embedded simulator's, so results that come through it are
protocol-verified, never Unity-verified; its metadata say so under `standIn`.
"""
