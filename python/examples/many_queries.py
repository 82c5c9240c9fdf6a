# SPDX-License-Identifier: MIT
"""Many queries on a Dask cluster: here of two processes, elsewhere Client("scheduler:8786")."""

import numpy
from distributed import Client, LocalCluster

import tutavia
from tutavia.distributed import plan_many, read_results

if __name__ == "__main__":
    random = numpy.random.default_rng(1)
    space = tutavia.CellSpace.from_numpy(random.random((256, 256)) < 0.8, resolution=0.1,
                                         safety_radius=0.02)
    queries = tutavia.Queries(random.uniform(0, 25.6, (2000, 2)), random.uniform(0, 25.6, (2000, 2)))

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster:
        with Client(cluster) as client:
            # Interrupt this and run it again: it goes on where the file ends.
            plan_many(client, space, queries, "many_queries.csv", search="jps", chunk=100)

    results = read_results("many_queries.csv")
    planned = results["status"] == "planned"
    print(f"{planned.sum()} of {len(planned)} have a plan, "
          f"{numpy.nanmean(results['length']):.2f} m on average")
