"""Behaviour trees of BehaviorTree.CPP 4: read, written, and translated from and to LLL where both mean the same."""
