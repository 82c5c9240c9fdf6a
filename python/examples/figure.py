# SPDX-License-Identifier: MIT
# %% A figure for a paper: one query, four smoothers.
import matplotlib.pyplot as plt
import tutavia

scene = tutavia.builtin_map("maze")
space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
start, goal = scene.start, scene.goals[2]

# %% Plan and draw.
figure, axes = plt.subplots(1, 4, figsize=(12, 3.4), layout="constrained")
for ax, smoother in zip(axes, ("none", "bezier", "delta", "clothoid")):
    plan = tutavia.plan(space, start, goal, smoother=smoother)
    plan.plot(ax)
    ax.set_title(f"{smoother}: {plan.length:.2f} m, "
                 f"curvature {plan.metrics.max_curvature:.1f}/m", fontsize=9)

# %% Save.
figure.savefig("figure.pdf")
print(f"figure.pdf; the shortest path has {space.shortest_length(start, goal):.2f} m")
