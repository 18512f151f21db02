"""Checks missions: explores a discrete model of agents and world, and decides properties on its states.

Programs are tables that the interpreter itself fills (`programs`). The discrete world (`roads`, `motion`, `traffic`) is
made from the numbers of a run (`abstraction`). Every verdict names the assumption about time that it was found under
(`timing`).
"""
