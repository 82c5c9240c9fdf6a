# SPDX-License-Identifier: MIT
"""Obstacles from shapely, a plan as arrays, the speed along it, and a failure."""

from shapely.geometry import Point, box

import tutavia

pillars = [Point(x, y).buffer(0.5) for x in range(2, 11, 3) for y in range(2, 8, 3)]
workspace = tutavia.Workspace((0, 0, 12, 9), [box(5, 3, 7, 6), *pillars], safety_radius=0.3)
space = tutavia.LatticeSpace(workspace, resolution=0.1)

plan = tutavia.plan(space, (0.5, 0.5), (11.5, 8.5))
curve = plan.curve.sample(0.05)
print(f"{plan.length:.2f} m, {len(curve.s)} samples, at most {abs(curve.curvature).max():.2f} 1/m, "
      f"clearance at least {plan.certificate.lower:.3f} m")

speed = plan.speed_profile(max_speed=1.5, max_jerk=2).sample(0.1)
print(f"driven in {speed.time[-1]:.1f} s, at most {speed.speed.max():.2f} m/s")

try:
    tutavia.plan(space, (0.5, 0.5), (6, 4))
except tutavia.GoalBlocked as failure:
    print(f"{failure.code} at {failure.point} by obstacle {failure.obstacle}; "
          f"{failure.nearest_safe_point} is safe")
