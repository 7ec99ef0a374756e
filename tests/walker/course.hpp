// SPDX-License-Identifier: BSD-3-Clause
// The timing of a walk: the phase of the gait at each moment, the footprints, and the resulting
// path of the root.
#pragma once

#include <vector>

#include "body.hpp"
#include "walker.hpp"

namespace walker {

/// Exact times in seconds.
struct Borders {
    double onset = 0;           ///< the first joint starts to move
    std::vector<double> passes; ///< times at which the legs pass each other; they bound the cycles
    double standstill = 0;      ///< the last joint stops
    double end = 0;
};

class Course {
  public:
    explicit Course(const Settings& settings);

    const Borders& borders() const { return borders_; }
    Pose pose(double seconds) const;
    Vector root(double seconds) const;

  private:
    /// Progress counts cycles from the landing of the first step; steps land at half integers.
    struct State {
        double progress = 0;
        double amplitude = 0;
        double lean = 0;
    };
    /// A foot on the floor; none of its points moves.
    struct Footprint {
        Vector heel;
        Vector ball;
    };

    double find_passing() const;
    double seconds_to(double progress) const;
    State gait_state(double seconds) const;
    State state(double seconds) const;
    double sway(double seconds) const;

    Side side_of(int step) const;
    double heading(double progress) const;
    double print_heading(int step) const;
    double foot_heading(double progress, Side side) const;
    Moment moment(const State& state) const;
    Pose pose(const State& state) const;
    void set_footprints();

    Settings settings_;
    Body body_;
    Sole sole_;
    double passing_;    ///< phase of the standing leg at which the other one passes it
    double last_lift_;  ///< progress at which the foot that closes up leaves the floor
    double tempo_;      ///< cycles per second at the first landing
    double tempo_gain_; ///< change of the tempo, cycles per second squared
    double last_tempo_; ///< tempo at the last lift
    double landing_s_;  ///< landing of the first step, seconds
    double last_lift_s_;
    Borders borders_;
    std::vector<Footprint> prints_; ///< [step + 1]; step -1 is the footprint before the first step
};

} // namespace walker
