# SPDX-License-Identifier: BSD-3-Clause
"""The best one-to-one map between two sets of labels."""

import numpy as np


def best_map(gain):
    """Pairs (row, column) with the largest sum; as many as the smaller side has. The Hungarian
    method with shortest augmenting paths (Jonker, Volgenant, Computing 38, 1987)."""
    if gain.shape[0] > gain.shape[1]:
        return [(row, column) for column, row in best_map(gain.T)]
    rows, columns = gain.shape
    cost = gain.max(initial=0) - gain
    of_row, of_column = np.zeros(rows + 1), np.zeros(columns + 1)
    owner = np.zeros(columns + 1, int)  # row of each column, from 1; 0: free
    for row in range(1, rows + 1):
        owner[0], column = row, 0
        shortest, before = np.full(columns + 1, np.inf), np.zeros(columns + 1, int)
        done = np.zeros(columns + 1, bool)
        while owner[column]:
            done[column] = True
            reach = cost[owner[column] - 1] - of_row[owner[column]] - of_column[1:]
            nearer = ~done[1:] & (reach < shortest[1:])
            shortest[1:][nearer], before[1:][nearer] = reach[nearer], column
            step = np.where(done, np.inf, shortest)
            step[0] = np.inf
            column = int(step.argmin())
            of_row[owner[done]] += step[column]
            of_column[done] -= step[column]
            shortest[~done] -= step[column]
        while column:
            owner[column] = owner[before[column]]
            column = before[column]
    return [(int(owner[column]) - 1, column - 1) for column in range(1, columns + 1)
            if owner[column]]
