"""The step of a whole run, machines and world, for all robots at once: one source, run by CPython or compiled by Numba.

In this order: robots fail or are revived; sensors measure; every machine whose tick it is is given what they read, then
all of these react, in team order; devices take the commands and move; robots move, and what touches is parted; shared
variables spread; and when nothing stirs, it is asked whether anything ever will.

Everything here and in what it calls is in the part of Python that Numba takes: loops over rows of numbers, whole
numbers that fit 64 bits, no division by zero, no function of the C library but the square root. So both give the same
numbers, bit by bit, and a run may pass from one to the other at any step. Rows are lists under CPython and arrays under
Numba. Nothing is allocated: the state has room for everything.
"""

from __future__ import annotations

from kitrobot.sim.columns import (
    A_FRESH,
    DOWN,
    EVENTS,
    LEFT,
    LIVING,
    LOAD,
    LOW_X,
    LOW_Y,
    MOVED,
    PLANNED,
    RADIUS,
    REVIVALS,
    ROLLING,
    RUNNING,
    S_ROBOT,
    S_STORE,
    S_VALUE,
    SOUND,
    STUCK,
    TICK,
    TOUCHING,
    TURN,
    X,
    Y,
)
from kitrobot.sim.commanding import busy, deliver
from kitrobot.sim.devices.arm import ARM_DEVICE, move_arms
from kitrobot.sim.devices.button import BUTTON, sense_buttons
from kitrobot.sim.devices.cargo import CARGO, sense_cargo
from kitrobot.sim.devices.collision import COLLISION_SENSOR, sense_collisions
from kitrobot.sim.devices.colour import COLOUR, sense_colours
from kitrobot.sim.devices.display import DISPLAY, move_displays
from kitrobot.sim.devices.door import DOOR, move_doors
from kitrobot.sim.devices.music import MUSIC, move_music
from kitrobot.sim.devices.presence import PRESENCE, sense_presence
from kitrobot.sim.devices.random import RANDOM, sense_randoms
from kitrobot.sim.devices.range import RANGE, sense_ranges
from kitrobot.sim.devices.sign import SIGN, sense_signs
from kitrobot.sim.devices.store import STORE, sense_stores
from kitrobot.sim.devices.turn import TURN_DEVICE, move_turns
from kitrobot.sim.devices.wheel import WHEEL_DEVICE, move_wheels
from kitrobot.sim.grids import fill
from kitrobot.sim.harming import harm_by_chance, harm_on_schedule
from kitrobot.sim.physics import CLOSED, move_robots, tell_leaving
from kitrobot.sim.reacting import react
from kitrobot.sim.sampling import sample, sample_done
from kitrobot.sim.sharing import exchange
from kitrobot.sim.standstill import (
    is_at_work,
    is_held,
    look_for_standstill,
    may_be_held,
    remember,
    stirred,
)
from kitrobot.sim.state import State

# What does not change in a run: state.fixed_real and state.fixed.
DT, WIDEST, FAILS, WIDTH, HEIGHT = range(5)
TOGETHER, SEES, MOST_EVENTS, FAILS_EVERY = range(4)


def advance(state: State, steps: int) -> int:
    """Runs up to so many steps and gives how many.

    It runs fewer when every program has ended, when all goals hold and only robots that something befell go on, when
    nothing can change any more (STUCK), or when there is no room for what may happen in one more step. What happens is
    written behind the EVENTS that are in `events` already.
    """
    (
        fixed,
        fixed_real,
        clock,
        events,
        real,
        whole,
        solid,
        guided,
        free,
        free_solid,
        carriers,
        program_code,
        commands,
        parts,
        cells,
        threads,
        pars,
        out,
        seen,
        was_cells,
        was_threads,
        was_pars,
        kept_cells,
        kept_threads,
        kept_pars,
        sensor,
        sensor_real,
        sensor_bank,
        past,
        actuator,
        actuator_real,
        actuator_bank,
        wires,
        waited_for,
        late,
        takens,
        faces,
        queue,
        shared,
        apart,
        mine_first,
        mine,
        mine_cell,
        copy_robot,
        copy_cell,
        plan,
        fate,
        roads,
        road_length,
        points,
        cut_from,
        cut_sign,
        docks,
        dock_road,
        stock,
        capacity,
        goals,
        walls,
        wall_frame,
        wall_shape,
        wall_starts,
        wall_items,
        stretches,
        colours,
        line_frame,
        line_shape,
        line_starts,
        line_items,
        floors,
        floor_box,
        floor_points,
        frame,
        shape,
        starts,
        items,
        ray_cells,
        ray_exits,
        pairs,
        before,
        buckets,
        chain,
        held,
    ) = state
    dt = fixed_real[DT]
    widest = fixed_real[WIDEST]
    most_events = fixed[MOST_EVENTS]
    closed = roads[CLOSED]
    sensor_robots = sensor[S_ROBOT]
    sensor_values = sensor[S_VALUE]
    turn = real[TURN]
    done = 0
    while done < steps and is_going_on(clock) and not is_reached(clock, goals, stock):
        if 5 * (clock[EVENTS] + most_events) > len(events):
            break
        step = clock[TICK]
        events_before = clock[EVENTS]
        looks = may_be_held(step, clock, len(plan[0]), fixed_real[FAILS])
        if looks:
            remember(real, actuator_real, held)

        if clock[PLANNED] < len(plan[0]):
            harm_on_schedule(
                step,
                plan,
                real,
                whole,
                cells,
                shared,
                apart,
                mine_first,
                mine,
                mine_cell,
                copy_robot,
                copy_cell,
                events,
                clock,
            )
        if fixed_real[FAILS] > 0.0:
            harm_by_chance(
                step,
                fixed[FAILS_EVERY],
                fixed_real[FAILS],
                fate,
                real,
                whole,
                cells,
                shared,
                apart,
                mine_first,
                mine,
                mine_cell,
                copy_robot,
                copy_cell,
                events,
                clock,
            )

        if sensor_bank[BUTTON] < sensor_bank[BUTTON + 1]:
            sense_buttons(sensor_bank[BUTTON], sensor_bank[BUTTON + 1], sensor_robots, whole[TOUCHING], sensor_values)
        if sensor_bank[CARGO] < sensor_bank[CARGO + 1]:
            sense_cargo(sensor_bank[CARGO], sensor_bank[CARGO + 1], sensor_robots, whole[LOAD], sensor_values)
        if fixed[SEES] and clock[MOVED]:
            clock[MOVED] = 0
            fill(
                solid,
                real[X],
                real[Y],
                real[RADIUS],
                widest,
                whole[LOW_X],
                whole[LOW_Y],
                frame,
                shape,
                starts,
                items,
            )
        if sensor_bank[COLLISION_SENSOR] < sensor_bank[COLLISION_SENSOR + 1]:
            sense_collisions(
                sensor_bank[COLLISION_SENSOR],
                sensor_bank[COLLISION_SENSOR + 1],
                sensor,
                sensor_real,
                real,
                whole,
                frame,
                shape,
                starts,
                items,
                ray_cells,
                ray_exits,
            )
        if sensor_bank[COLOUR] < sensor_bank[COLOUR + 1]:
            sense_colours(
                sensor_bank[COLOUR],
                sensor_bank[COLOUR + 1],
                sensor,
                sensor_real,
                real,
                whole,
                stretches,
                colours,
                line_frame,
                line_shape,
                line_starts,
                line_items,
                floors,
                floor_box,
                floor_points,
            )
        if sensor_bank[PRESENCE] < sensor_bank[PRESENCE + 1]:
            sense_presence(
                sensor_bank[PRESENCE],
                sensor_bank[PRESENCE + 1],
                sensor,
                sensor_real,
                real,
                whole,
                carriers,
                docks,
                dock_road,
                road_length,
                closed,
            )
        if sensor_bank[RANDOM] < sensor_bank[RANDOM + 1]:
            sense_randoms(sensor_bank[RANDOM], sensor_bank[RANDOM + 1], step, sensor, whole)
        if sensor_bank[RANGE] < sensor_bank[RANGE + 1]:
            sense_ranges(
                sensor_bank[RANGE],
                sensor_bank[RANGE + 1],
                step,
                sensor,
                sensor_real,
                real,
                whole,
                walls,
                wall_frame,
                wall_shape,
                wall_starts,
                wall_items,
                frame,
                shape,
                starts,
                items,
                ray_cells,
                ray_exits,
            )
        if sensor_bank[SIGN] < sensor_bank[SIGN + 1]:
            sense_signs(
                sensor_bank[SIGN],
                sensor_bank[SIGN + 1],
                sensor,
                sensor_real,
                real,
                whole,
                roads,
                road_length,
                cut_from,
                cut_sign,
            )
        if sensor_bank[STORE] < sensor_bank[STORE + 1]:
            sense_stores(sensor_bank[STORE], sensor_bank[STORE + 1], sensor[S_STORE], stock, sensor_values)

        sample(step, sensor, sensor_real, past, whole, cells)
        if len(waited_for) > 0:
            sample_done(step, waited_for, actuator, whole, cells)
        ran = react(
            step,
            whole,
            program_code,
            commands,
            parts,
            cells,
            threads,
            pars,
            out,
            seen,
            was_cells,
            was_threads,
            was_pars,
            wires,
            takens,
            actuator,
            actuator_real,
            real,
            faces,
            queue,
            events,
            clock,
        )

        if len(late) > 0:
            deliver(step, late, actuator, actuator_real, real, whole, faces, queue)
        if actuator_bank[ARM_DEVICE] < actuator_bank[ARM_DEVICE + 1]:
            move_arms(
                actuator_bank[ARM_DEVICE],
                actuator_bank[ARM_DEVICE + 1],
                dt,
                actuator,
                actuator_real,
                real,
                whole,
                carriers,
                docks,
                dock_road,
                road_length,
                closed,
                stock,
                capacity,
                events,
                clock,
            )
        if actuator_bank[DISPLAY] < actuator_bank[DISPLAY + 1]:
            move_displays(
                actuator_bank[DISPLAY],
                actuator_bank[DISPLAY + 1],
                dt,
                actuator,
                actuator_real,
                faces,
                whole[DOWN],
            )
        if actuator_bank[DOOR] < actuator_bank[DOOR + 1]:
            move_doors(actuator_bank[DOOR], actuator_bank[DOOR + 1], dt, actuator, actuator_real, whole[DOWN])
        if actuator_bank[MUSIC] < actuator_bank[MUSIC + 1]:
            move_music(actuator_bank[MUSIC], actuator_bank[MUSIC + 1], dt, actuator, actuator_real, faces, whole[DOWN])
        if actuator_bank[TURN_DEVICE] < actuator_bank[TURN_DEVICE + 1]:
            move_turns(
                actuator_bank[TURN_DEVICE],
                actuator_bank[TURN_DEVICE + 1],
                dt,
                actuator,
                actuator_real,
                turn,
                whole[DOWN],
            )
        if actuator_bank[WHEEL_DEVICE] < actuator_bank[WHEEL_DEVICE + 1]:
            move_wheels(
                actuator_bank[WHEEL_DEVICE],
                actuator_bank[WHEEL_DEVICE + 1],
                dt,
                actuator,
                actuator_real,
                real,
                whole[DOWN],
            )
        move_robots(
            dt,
            widest,
            fixed[TOGETHER],
            real,
            whole,
            solid,
            guided,
            free,
            free_solid,
            roads,
            road_length,
            points,
            walls,
            wall_frame,
            wall_shape,
            wall_starts,
            wall_items,
            frame,
            shape,
            starts,
            items,
            pairs,
            before,
            buckets,
            chain,
            events,
            clock,
        )
        if clock[ROLLING] > 0 and len(free_solid) > 0:
            tell_leaving(
                free_solid, real[X], real[Y], fixed_real[WIDTH], fixed_real[HEIGHT], whole[LEFT], events, clock
            )
        if len(mine) > 0 and ran > 0:
            exchange(
                step,
                whole,
                cells,
                shared,
                apart,
                mine_first,
                mine,
                mine_cell,
                copy_robot,
                copy_cell,
                events,
                clock,
            )
        clock[TICK] = step + 1
        done += 1

        if clock[ROLLING] == 0:
            stirs = is_stirring(step, actuator, actuator_real, real, whole)
        else:
            stirs = (
                not looks or is_at_work(step, actuator, actuator_real, whole) or not is_held(real, actuator_real, held)
            )
        if stirs or clock[EVENTS] > events_before:
            stirred(clock)
        elif clock[RUNNING] > 0:
            look_for_standstill(whole, cells, threads, pars, kept_cells, kept_threads, kept_pars, clock)
    return done


def is_going_on(clock: list[int]) -> bool:
    """Whether the run has not come to its end: somebody goes on, or failed and is to be revived."""
    return clock[STUCK] == 0 and clock[RUNNING] > 0 and (clock[LIVING] > 0 or clock[REVIVALS] > 0)


def is_reached(clock: list[int], goals: list[list[int]], stock: list[int]) -> bool:
    """Whether every goal holds and nobody is left who could say so by ending its program: those whose programs have not
    ended failed, stalled or lost their radio, and none is to be revived. `goals` are the storehouses and their stock.
    """
    if clock[SOUND] > 0 or clock[REVIVALS] > 0 or len(goals[0]) == 0:
        return False
    n = 0
    while n < len(goals[0]) and stock[goals[0][n]] == goals[1][n]:
        n += 1
    return n == len(goals[0])


def is_stirring(
    step: int,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
) -> bool:
    """Whether a device was told something new in this step, or has something to do."""
    fresh = actuator[A_FRESH]
    count = len(fresh)
    k = 0
    while k < count and fresh[k] != step + 1 and not busy(k, actuator, actuator_real, real, whole):
        k += 1
    return k < count
