"""The astronaut's clips, sampled into keys: feet that carry weight are placed first, the legs follow by two-bone
inverse kinematics, so nothing that stands slides.

A pose is {"hips": place, joint: turn}; turns are local, and the identity is the bind pose.
"""

import math

from astronaut import ANKLE_M, ARM, ARM_DEG, BALL_M, HALF_HIPS_M, HEEL_M, JOINTS, SHIN_M, THIGH_M, TIP_M
from vectors import (IDENTITY, add, chain, cross, dot, from_axes, inverse, length, mix, mul, nlerp, rotate, smooth, sub,
                     times, turn, turn_x, turn_y, turn_z, unit)

TAU = 2.0 * math.pi
HIPS_M = JOINTS["hips"][1][1]
SIDES = (("L", -1.0), ("R", 1.0))


def world_turn(pose, joint):
    out = IDENTITY
    while joint is not None:
        out = times(pose.get(joint, IDENTITY), out)
        joint = JOINTS[joint][0]
    return out


def world_place(pose, joint):
    """Where a joint is in the model."""
    parent, place = JOINTS[joint]
    if parent is None:
        return pose["place"]
    offset = sub(place, JOINTS[parent][1])
    return add(world_place(pose, parent), rotate(world_turn(pose, parent), offset))


def arm(pose, side, swing=0.0, out=8.0, elbow=15.0, twist=0.0, hand=0.0):
    """Upper arm `swing` ahead of hanging and `out` from the side, forearm bent by `elbow`; degrees."""
    sign = 1.0 if side == "R" else -1.0
    # The bind pose holds the arm ARM_DEG out; a turn about x by -sign takes it further out.
    pose[f"upper_arm.{side}"] = chain(turn_z(swing), turn_x(sign * (ARM_DEG - out)), turn_arm(sign, twist))
    # The elbow's axis stands at right angles to the arm as bound: z, tilted with it.
    axis = (0.0, sign * ARM[2], -ARM[1])
    pose[f"lower_arm.{side}"] = turn(axis, elbow)
    pose[f"hand.{side}"] = turn(axis, hand)


def turn_arm(sign, degrees):
    """A twist about the arm as bound."""
    return turn((ARM[0], ARM[1], ARM[2] * sign), degrees * sign)


def leg(pose, side, ankle, pitch=0.0, toe=0.0, spread=0.0):
    """Sets thigh and shin so that the ankle is at its place, knee ahead; the foot keeps its pitch (toes up positive).

    Returns by how much the place was out of reach, metres.
    """
    sign = 1.0 if side == "R" else -1.0
    hips = world_turn(pose, "hips")
    joint = world_place(pose, f"thigh.{side}")
    way = sub(ankle, joint)
    reach = length(way)
    most = (THIGH_M + SHIN_M) * 0.9995
    lack = max(reach - most, 0.0)
    reach = min(reach, most)
    # The knee opens where the hips face, a little outward.
    ahead = rotate(hips, rotate(turn_y(-sign * (4.0 + spread)), (1.0, 0.0, 0.0)))
    # Law of cosines: the angle at the hip between thigh and the line to the ankle.
    bend = math.acos(min((THIGH_M**2 + reach**2 - SHIN_M**2) / (2.0 * THIGH_M * reach), 1.0))
    line = unit(way)
    axis = unit(cross(line, ahead))
    thigh = rotate(turn(axis, math.degrees(bend)), line)
    knee = add(joint, mul(thigh, THIGH_M))
    shin = unit(sub(add(joint, mul(line, reach)), knee))
    thigh_turn = _down(thigh, axis)
    shin_turn = _down(shin, axis)
    pose[f"thigh.{side}"] = times(inverse(hips), thigh_turn)
    pose[f"shin.{side}"] = times(inverse(thigh_turn), shin_turn)
    foot = turn_z(pitch)
    pose[f"foot.{side}"] = times(inverse(shin_turn), foot)
    pose[f"toe.{side}"] = turn_z(toe)
    return lack


def _down(way, axis):
    """The turn that carries straight down to `way` and the right-hand axis to `axis`."""
    y = mul(way, -1.0)
    return from_axes(unit(cross(y, axis)), y, axis)


def standing(at=None, **more):
    pose = {"place": at or (0.0, HIPS_M - 0.012, 0.0)}
    pose.update(more)
    return pose


def plant(pose, spread=0.0):
    for side, sign in SIDES:
        leg(pose, side, (0.0, ANKLE_M, sign * (HALF_HIPS_M + spread)), spread=4.0)
    return pose


def _on_heel(x, pitch):
    """Ankle and toes when the heel rests at x and the foot is pitched up about it."""
    return add((x, 0.0, 0.0), rotate(turn_z(pitch), (-HEEL_M, ANKLE_M, 0.0))), pitch, 0.0


def _on_ball(x, pitch):
    """The same when the ball rests at x under flat toes and the heel is up (pitch below 0)."""
    joint = (x, 0.03, 0.0)
    return add(joint, rotate(turn_z(pitch), (-BALL_M, ANKLE_M - 0.03, 0.0))), pitch, -pitch


def _depth(pitch, toe):
    """How far the lowest point of the sole is below the ankle."""
    foot, tip = turn_z(pitch), turn_z(pitch + toe)
    ball = rotate(foot, (BALL_M, 0.03 - ANKLE_M, 0.0))
    ends = [rotate(foot, (HEEL_M, -ANKLE_M, 0.0)), add(ball, rotate(tip, (-0.03, -0.03, 0.0))),
            add(ball, rotate(tip, (TIP_M - BALL_M, -0.03, 0.0)))]
    return -min(end[1] for end in ends)


class Gait:
    """A walk or run: one foot's path over a cycle, the other's half a cycle later."""

    def __init__(self, speed, period, stance, strike, flat, lift_from, toe_off, lift, kick):
        self.speed, self.period, self.stance = speed, period, stance
        self.strike, self.flat, self.lift_from, self.toe_off = strike, flat, lift_from, toe_off
        self.lift, self.kick = lift, kick
        self.travel = speed * period * stance

    def foot(self, phase):
        """Ankle (x, y), pitch and toe of a foot at a phase in 0 to 1, stance first."""
        phase %= 1.0
        if phase < self.stance:
            return self._standing(phase / self.stance)
        t = (phase - self.stance) / (1.0 - self.stance)
        start, end = self._standing(1.0), self._standing(0.0)
        # Leaves and comes back with the ground's own speed, so the path has no kink: a cubic Hermite.
        rush = -self.speed * self.period * (1.0 - self.stance)
        h = ((2 * t - 3) * t * t + 1, ((t - 2) * t + 1) * t, (3 - 2 * t) * t * t, (t - 1) * t * t)
        x = h[0] * start[0][0] + h[1] * rush + h[2] * end[0][0] + h[3] * rush
        y = start[0][1] + (end[0][1] - start[0][1]) * smooth(t) + self.lift * math.sin(math.pi * t) ** 2
        y += self.kick * math.sin(math.pi * min(t * 1.6, 1.0)) ** 2
        droop = -self.kick * 110.0 * math.sin(math.pi * min(t * 1.5, 1.0)) ** 2
        pitch = start[1] + (end[1] - start[1]) * smooth(t * 1.25) + droop
        toe = start[2] * (1.0 - smooth(t * 2.0))
        # The sole clears the ground before the foot has left the ground's own speed, and until it comes back to it.
        clear = 0.04 * smooth(min(t, 1.0 - t) / 0.25)
        return (x, max(y, clear + _depth(pitch, toe)), 0.0), pitch, toe

    def _standing(self, s):
        x = self.travel * (0.5 - s) - 0.01
        if s < self.flat:
            return _on_heel(x + HEEL_M, self.strike * (1.0 - smooth(s / self.flat)))
        if s < self.lift_from:
            return _on_heel(x + HEEL_M, 0.0)
        share = (s - self.lift_from) / (1.0 - self.lift_from)
        return _on_ball(x + BALL_M, -self.toe_off * share * share)


WALK = Gait(1.4, 0.78, 0.60, 18.0, 0.22, 0.45, 42.0, 0.05, 0.02)
RUN = Gait(4.5, 0.54, 0.27, 6.0, 0.30, 0.45, 52.0, 0.10, 0.22)


def walk(t):
    a = TAU * t
    pose = standing((0.0, 0.818 - 0.016 * math.cos(2 * a - 0.5), 0.018 * math.sin(a)))
    pose["hips"] = chain(turn_y(5.0 * math.cos(a)), turn_x(2.5 * math.sin(a)), turn_z(-2.0))
    pose["spine"] = chain(turn_y(-5.0 * math.cos(a)), turn_x(-2.0 * math.sin(a)), turn_z(-1.5))
    pose["chest"] = chain(turn_y(-6.0 * math.cos(a)), turn_z(-1.0))
    pose["head"] = chain(turn_y(5.0 * math.cos(a)), turn_z(3.0 + 1.2 * math.cos(2 * a)))
    for side, sign in SIDES:
        swing = -26.0 * math.cos(a) * sign
        arm(pose, side, swing, 9.0, 20.0 + 0.35 * max(swing, 0.0) + 4.0)
    return pose, _steps(pose, WALK, t, 0.105)


def run(t):
    a = TAU * t
    pose = standing((0.0, 0.815 + 0.035 * math.cos(2 * a - 3.65), 0.008 * math.sin(a)))
    pose["hips"] = chain(turn_y(9.0 * math.cos(a)), turn_z(-9.0))
    pose["spine"] = chain(turn_y(-9.0 * math.cos(a)), turn_z(-4.0))
    pose["chest"] = chain(turn_y(-10.0 * math.cos(a)), turn_z(-3.0))
    pose["head"] = chain(turn_y(9.0 * math.cos(a)), turn_z(13.0))
    for side, sign in SIDES:
        swing = -46.0 * math.cos(a) * sign - 6.0
        arm(pose, side, swing, 12.0, 78.0 + 0.30 * swing)
    return pose, _steps(pose, RUN, t, 0.09)


def _steps(pose, gait, t, half_width):
    """Places both feet; returns the worst lack of reach while a foot stands."""
    worst = 0.0
    for side, sign in SIDES:
        # The right foot strikes at phase 0.
        phase = (t + (0.0 if side == "R" else 0.5)) % 1.0
        place, pitch, toe = gait.foot(phase)
        lack = leg(pose, side, add(place, (0.0, 0.0, sign * half_width)), pitch, toe)
        if phase <= gait.stance:
            worst = max(worst, lack)
    return worst


def idle(t):
    a = TAU * t
    pose = standing((0.004 * math.sin(a), HIPS_M - 0.022 - 0.006 * math.cos(2 * a), 0.010 * math.sin(a)))
    pose["hips"] = turn_x(0.8 * math.sin(a))
    pose["spine"] = chain(turn_x(-1.2 * math.sin(a)), turn_z(-0.5 - 0.8 * math.cos(2 * a)))
    pose["chest"] = turn_z(0.8 + 1.4 * math.cos(2 * a - 0.6))
    pose["head"] = chain(turn_y(9.0 * math.sin(a + 0.4)), turn_z(1.5 * math.sin(2 * a)))
    for side, sign in SIDES:
        pose[f"shoulder.{side}"] = turn_x(-sign * 1.5 * math.cos(2 * a - 0.6))
        arm(pose, side, 3.0 + 2.0 * math.sin(a + sign * 0.7), 11.0 + 1.2 * math.cos(2 * a), 14.0 + 2.0 * math.sin(a))
    return plant(pose, 0.015), 0.0


def fall(t):
    a = TAU * t
    pose = standing((0.0, HIPS_M, 0.0))
    pose["hips"] = chain(turn_x(3.0 * math.sin(a)), turn_z(-6.0))
    pose["spine"] = turn_z(-4.0 + 2.0 * math.cos(a))
    pose["chest"] = chain(turn_y(4.0 * math.sin(a)), turn_z(-2.0))
    pose["head"] = turn_z(-8.0)
    for side, sign in SIDES:
        arm(pose, side, 10.0 + 16.0 * math.cos(a + (0.0 if sign > 0 else 2.2)), 82.0 + 12.0 * math.sin(a), 28.0)
        swing = math.sin(a + (0.0 if sign > 0 else math.pi))
        leg(pose, side, (0.05 + 0.10 * swing, 0.215 + 0.03 * swing, sign * 0.17), -22.0 + 6.0 * swing, -6.0)
    return pose, 0.0


def hold(t):
    """Only what is above the belt: the right hand carries something upright ahead, the left arm keeps balance."""
    a = TAU * t
    pose = standing()
    pose["spine"] = turn_y(3.0)
    pose["chest"] = chain(turn_y(5.0), turn_z(0.6 * math.cos(a)))
    pose["shoulder.R"] = turn_x(-2.0)
    arm(pose, "R", 24.0 + 1.2 * math.sin(a), 10.0, 70.0 + 1.0 * math.cos(a), -6.0)
    arm(pose, "L", 2.0 + 1.5 * math.sin(a), 11.0, 18.0)
    # What is held stands upright and points ahead whatever the arm does.
    pose["hand.R"] = chain(inverse(world_turn(pose, "lower_arm.R")), turn_z(-8.0))
    for joint in list(pose):
        if joint not in ("place", "spine", "chest", "shoulder.R") and "arm" not in joint and "hand" not in joint:
            del pose[joint]
    return pose, 0.0


def sit(t):
    """At the wheel of the car: leaning back, knees up, hands on the rim; the origin is 0.40 m above the ground."""
    a = TAU * t
    pose = standing((0.0, 0.10, 0.0), hips=turn_z(17.0), spine=turn_z(-3.0), chest=turn_z(-4.0 + 0.5 * math.cos(a)))
    pose["head"] = chain(turn_y(3.0 * math.sin(a)), turn_z(-9.0))
    for side, sign in SIDES:
        arm(pose, side, 58.0, 7.0, 28.0, 0.0, -14.0)
        leg(pose, side, (0.53, 0.03, sign * 0.12), 28.0, 0.0, 6.0)
    return pose, 0.0


def rest(t):
    """On the ground: knees up, forearms on them, looking about; the feet stand still."""
    a = TAU * t
    pose = standing((-0.20, 0.21 + 0.004 * math.cos(2.0 * a), 0.0), hips=turn_z(24.0), spine=turn_z(-14.0),
                    chest=turn_z(-16.0 + 0.8 * math.cos(2.0 * a)))
    pose["head"] = chain(turn_y(16.0 * math.sin(a)), turn_z(4.0 + 3.0 * math.sin(2.0 * a)))
    for side, sign in SIDES:
        arm(pose, side, 62.0, 12.0, 22.0, 0.0, -20.0)
        leg(pose, side, (0.24, ANKLE_M, sign * (HALF_HIPS_M + 0.03)), 0.0, 0.0, 6.0)
    return pose, 0.0


def perch(t):
    """On a stone or a stump 0.42 m high, a hand on each thigh; the place is between what is sat on and the feet."""
    a = TAU * t
    pose = standing((-0.25, 0.575 + 0.004 * math.cos(2.0 * a), 0.0), hips=turn_z(8.0), spine=turn_z(-10.0),
                    chest=turn_z(-11.0 + 0.8 * math.cos(2.0 * a)))
    pose["head"] = chain(turn_y(18.0 * math.sin(a)), turn_z(5.0 + 3.0 * math.sin(2.0 * a)))
    for side, sign in SIDES:
        arm(pose, side, 26.0, 4.0, 44.0, 0.0, -12.0)
        leg(pose, side, (0.20, ANKLE_M, sign * (HALF_HIPS_M + 0.03)), 0.0, 0.0, 8.0)
    return pose, 0.0


def _between(keys, t):
    """Poses at times, joined by easing; `keys` are (time, pose, feet or None)."""
    for (t0, p0), (t1, p1) in zip(keys, keys[1:]):
        if t <= t1:
            s = smooth((t - t0) / (t1 - t0))
            out = {"place": mix(p0["place"], p1["place"], s)}
            for joint in sorted((set(p0) | set(p1)) - {"place"}):
                out[joint] = nlerp(p0.get(joint, IDENTITY), p1.get(joint, IDENTITY), s)
            return out
    return keys[-1][1]


def _body(height, ahead, lean, spine, head, arms, x=0.0):
    """A pose from the waist up: lean of the hips and bend of the spine (ahead positive), arms (swing, out, elbow)."""
    pose = standing((x + ahead, height, 0.0), hips=turn_z(-lean), spine=turn_z(-spine * 0.6), chest=turn_z(-spine * 0.4),
                    head=turn_z(head))
    for side, _ in SIDES:
        arm(pose, side, *arms)
    return pose


def _feet(pose, right, left):
    for (side, sign), foot in zip((("R", 1.0), ("L", -1.0)), (right, left)):
        x, y, pitch, toe = foot
        leg(pose, side, (x, y, sign * (HALF_HIPS_M + 0.01)), pitch, toe)
    return pose


FLAT = (0.0, ANKLE_M, 0.0, 0.0)


def _jump_keys():
    crouch = _feet(_body(0.74, -0.03, 16.0, 14.0, 8.0, (-38.0, 16.0, 24.0)), FLAT, FLAT)
    push = _feet(_body(0.90, 0.03, 3.0, -6.0, 4.0, (96.0, 24.0, 30.0)), (-0.02, 0.20, -48.0, 20.0),
                 (-0.02, 0.20, -48.0, 20.0))
    tuck = _feet(_body(0.88, 0.0, 10.0, 6.0, -2.0, (48.0, 52.0, 42.0)), (0.20, 0.42, -14.0, 0.0),
                 (-0.12, 0.30, -46.0, 0.0))
    hang = _feet(_body(0.87, 0.0, 6.0, 4.0, -6.0, (18.0, 74.0, 32.0)), (0.11, 0.27, -18.0, 0.0),
                 (-0.04, 0.22, -30.0, 0.0))
    return [(0.0, crouch), (0.12, push), (0.36, tuck), (0.62, hang)]


def _hit_keys():
    rest = _feet(_body(HIPS_M - 0.02, 0.0, 0.0, 0.0, 0.0, (3.0, 11.0, 14.0)), FLAT, FLAT)
    struck = _feet(_body(HIPS_M - 0.07, -0.06, -9.0, -12.0, -22.0, (34.0, 38.0, 46.0)), FLAT, FLAT)
    struck["spine"] = times(turn_y(-14.0), struck["spine"])
    back = _feet(_body(HIPS_M - 0.05, 0.02, 7.0, 10.0, 6.0, (-6.0, 20.0, 26.0)), FLAT, FLAT)
    return [(0.0, rest), (0.09, struck), (0.26, back), (0.46, rest)]


def _die_keys():
    rest = _feet(_body(HIPS_M - 0.02, 0.0, 0.0, 0.0, 0.0, (3.0, 11.0, 14.0)), FLAT, FLAT)
    reel = _feet(_body(0.79, -0.07, -10.0, -12.0, -18.0, (30.0, 44.0, 40.0)), FLAT, FLAT)
    buckle = _feet(_body(0.56, 0.16, 4.0, 20.0, -14.0, (10.0, 24.0, 30.0)), (-0.14, 0.19, -46.0, 40.0),
                   (-0.14, 0.19, -46.0, 40.0))
    kneel = _feet(_body(0.455, 0.20, 8.0, 26.0, -20.0, (4.0, 16.0, 18.0)), (-0.20, 0.20, -62.0, 30.0),
                  (-0.18, 0.20, -62.0, 30.0))
    pitch = _feet(_body(0.36, 0.36, 48.0, 18.0, 6.0, (72.0, 40.0, 40.0)), (-0.24, 0.20, -74.0, 20.0),
                  (-0.22, 0.20, -74.0, 20.0))
    lie = _flat(0.235, 0.44, 88.0, -4.0)
    bounce = _flat(0.255, 0.44, 85.0, -1.0)
    return [(0.0, rest), (0.14, reel), (0.44, buckle), (0.66, kneel), (0.94, pitch), (1.16, lie), (1.26, bounce),
            (1.40, lie), (1.50, lie)]


def _flat(height, ahead, lean, spine):
    """Face down: legs behind, arms beside the helmet."""
    pose = _body(height, ahead, lean, spine, 4.0, (96.0, 62.0, 62.0))
    pose["head"] = chain(turn_y(24.0), turn_z(6.0))
    for side, sign in SIDES:
        pose[f"thigh.{side}"] = chain(turn_x(-sign * 8.0), turn_z(3.0 if sign > 0 else -2.0))
        pose[f"shin.{side}"] = turn_z(-8.0 if sign > 0 else -3.0)
        pose[f"foot.{side}"] = turn_z(-58.0)
        pose[f"toe.{side}"] = turn_z(-8.0)
    return pose


def _loop(make, seconds, count):
    poses = [make(i / count)[0] for i in range(count)]
    lack = max(make(i / (8 * count))[1] for i in range(8 * count))
    assert lack < 0.002, f"a standing foot is {lack} m out of reach"
    # The last key is the first again, so the loop closes exactly.
    return [i * seconds / count for i in range(count + 1)], poses + poses[:1]


def _once(keys, rate=24.0):
    seconds = keys[-1][0]
    count = round(seconds * rate)
    times_ = [i * seconds / count for i in range(count + 1)]
    return times_, [_between(keys, t) for t in times_]


def clips():
    """name -> (key times, poses, extras)."""
    extras = lambda speed, loop: {"ground_speed_m_s": speed, "loop": loop}
    return {
        "idle": (*_loop(idle, 4.0, 24), extras(0.0, True)),
        "walk": (*_loop(walk, WALK.period, 32), extras(WALK.speed, True)),
        "run": (*_loop(run, RUN.period, 32), extras(RUN.speed, True)),
        "jump": (*_once(_jump_keys()), extras(0.0, False)),
        "fall": (*_loop(fall, 1.2, 16), extras(0.0, True)),
        "hold": (*_loop(hold, 3.0, 12), dict(extras(0.0, True), layer="upper body")),
        "hit": (*_once(_hit_keys()), extras(0.0, False)),
        "die": (*_once(_die_keys()), extras(0.0, False)),
        "sit": (*_loop(sit, 5.0, 10), extras(0.0, True)),
        "rest": (*_loop(rest, 7.0, 14), extras(0.0, True)),
        "perch": (*_loop(perch, 8.0, 16), extras(0.0, True)),
    }


def skinned(pose, place, normal, weights):
    """A vertex of the bind pose in a pose."""
    p, n = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    for joint, weight in weights:
        q, at = pose["joints"][joint]
        p = add(p, mul(add(at, rotate(q, sub(place, JOINTS[joint][1]))), weight))
        n = add(n, mul(rotate(q, normal), weight))
    return p, unit(n)


def posed(pose):
    """The pose with where every joint is and how it is turned in the model."""
    pose = dict(pose)
    pose["joints"] = {j: (world_turn(pose, j), world_place(pose, j)) for j in JOINTS}
    return pose
