# From power-on to the loop. The order is what makes it fit a small board: the program's arrays first, while there is
# room to compile their reader; then the interpreter, which is the largest; then the rest. What was needed once is
# forgotten.


def start(port, package, program, generation):
    """Loads a program file (None: there is none) and goes on until somebody asks for the prompt."""
    number = 0
    text = ""
    loaded = None
    try:
        if program:
            from kitrobot_onboard import program as reading

            loaded = reading.load(program)
    except MemoryError:
        number = 3
    except Exception as error:
        number = 4
        text = repr(error)
    if program:
        from kitrobot_onboard import arrays

        del reading.load, reading.is_whole, arrays.arrays
    from kitrobot_onboard.robot import Robot

    robot = Robot(port, package + " " + (program[2:] if program else "-"), generation)
    if loaded:
        from kitrobot_onboard import equip

        try:
            text = equip.equip(robot, loaded[3])
            number = 5 if text else 0
            if not number:
                robot.take(program, loaded)
        except MemoryError:
            number = 3
        del equip.equip, loaded
    port.enter()
    try:
        if number:
            robot.fail(number, 65535, text)
        elif robot.cells is not None:
            robot.begin(False)
        robot.run()
    finally:
        port.leave()
