#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plans on two machines, as far as one machine can tell: two network namespaces joined by a cable, with
# a scheduler and a worker in the one and a worker and the client in the other. As root, by hand:
#
#   PYTHONPATH=build/python/python python/benchmarks/two_machines.sh [COUNT]
set -euo pipefail
count=${1:-5000}
python=/usr/bin/python3
folder=$(mktemp -d)
pids=()
cleanup() {
  kill "${pids[@]}" 2>/dev/null || true
  wait 2>/dev/null || true
  ip netns del tutavia_a 2>/dev/null || true
  ip netns del tutavia_b 2>/dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT

ip netns add tutavia_a
ip netns add tutavia_b
ip link add cable_a netns tutavia_a type veth peer name cable_b netns tutavia_b
for side in a b; do
  [ $side = a ] && address=10.77.0.1 || address=10.77.0.2
  ip -n tutavia_$side address add $address/24 dev cable_$side
  ip -n tutavia_$side link set cable_$side up
  ip -n tutavia_$side link set lo up
done

cd "$folder"
ip netns exec tutavia_a $python -m distributed.cli.dask_scheduler --host 10.77.0.1 --port 8786 \
  --no-dashboard >scheduler.log 2>&1 &
pids+=($!)
for side in a b; do
  ip netns exec tutavia_$side $python -m distributed.cli.dask_worker tcp://10.77.0.1:8786 \
    --nthreads 1 --no-dashboard --local-directory "$folder/$side" >worker_$side.log 2>&1 &
  pids+=($!)
done
ip netns exec tutavia_b $python - "$count" <<'PROGRAM'
import sys
import numpy
from distributed import Client
import tutavia
from tutavia.distributed import HEADER, plan_many

count = int(sys.argv[1])
scene = tutavia.builtin_map("maze")
space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
points = numpy.random.default_rng(6).uniform(0, 16, (count, 4))
with Client("tcp://10.77.0.1:8786", timeout=30) as client:
    client.wait_for_workers(2, timeout=30)
    before = {address: 0 for address in client.nthreads()}
    plan_many(client, space, points, "results.csv", chunk=100)
    tasks = client.run(lambda dask_worker: dask_worker.state.executed_count
                       if hasattr(dask_worker, "state") else -1)
batch = tutavia.plan_batch(space, points[:, :2], points[:, 2:], keep_plans=False)
same = open("results.csv").read() == HEADER + "\n" + batch._lines(0)
print(f"workers {sorted(tasks.items())} (tasks each), {count} results, "
      f"equal to one process: {same}")
sys.exit(0 if same else 1)
PROGRAM
