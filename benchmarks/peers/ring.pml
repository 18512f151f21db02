/* A ring road of 8 zones, carriers that bring boxes from dock A (zone 0) to dock B (zone 4), a loader, an unloader and
 * two store-managers; every agent may lag. The counterpart of the transport mission for SPIN. */
#ifndef CARRIERS
#define CARRIERS 2
#endif
#ifndef BOXES
#define BOXES 1
#endif
#define ZONES 8
#define A 0
#define B 4

byte zone[CARRIERS];
bit told[CARRIERS], rolls[CARRIERS], near[CARRIERS], load[CARRIERS], fresh[CARRIERS];
byte stock_a = BOXES, stock_b = 0, said_a = 0;
bit going = 1, loads = 0, unloads = 0;

#ifdef LIVE
ltl delivered { <> (stock_b == BOXES) }
#endif

inline step_into(me) {
  d_step {
    zone[me] = (zone[me] + 1) % ZONES;
    fresh[me] = 1;
    near[me] = 0
  }
}

proctype Carrier(byte me) {
  byte dock = A;
  do
  :: !going -> break
  :: else ->
    atomic { told[me] = 1; fresh[me] = 0 }
    do
    :: atomic { zone[me] == dock || !going -> told[me] = 0; fresh[me] = 0; break }
    :: atomic { else -> told[me] = !near[me]; fresh[me] = 0 }
    od;
    do
    :: !going -> break
    :: atomic { going && load[me] == (dock == A) -> dock = (load[me] -> B : A); break }
    od
  od
}

proctype Motion(byte me) {
  byte other;
  do
  :: atomic { told[me] && !rolls[me] -> rolls[me] = 1 }
  :: atomic { !told[me] && rolls[me] -> rolls[me] = 0 }
  :: atomic {
       rolls[me] && !fresh[me] && CARRIERS > 1 && zone[(me + 1) % CARRIERS] == (zone[me] + 1) % ZONES && !near[me] ->
       near[me] = 1
     }
  :: atomic { near[me] && zone[(me + 1) % CARRIERS] != (zone[me] + 1) % ZONES -> near[me] = 0 }
  :: atomic {
       rolls[me] && !fresh[me] && (CARRIERS == 1 || zone[(me + 1) % CARRIERS] != (zone[me] + 1) % ZONES) ->
       step_into(me)
     }
  :: atomic { !going && !rolls[me] && !told[me] -> break }
  od
}

proctype Loader() {
  byte i;
  do
  :: !going -> break
  :: atomic {
       going && said_a > 0 && !loads ->
       i = 0;
       do
       :: i < CARRIERS && zone[i] == A && !rolls[i] && !load[i] -> loads = 1; break
       :: i < CARRIERS && !(zone[i] == A && !rolls[i] && !load[i]) -> i++
       :: i == CARRIERS -> break
       od;
       i = 0
     }
  :: atomic {
       loads ->
       loads = 0;
       i = 0;
       do
       :: i < CARRIERS && zone[i] == A && !rolls[i] && !load[i] && stock_a > 0 -> load[i] = 1; stock_a--; break
       :: i < CARRIERS && !(zone[i] == A && !rolls[i] && !load[i] && stock_a > 0) -> i++
       :: i == CARRIERS -> break
       od;
       i = 0
     }
  od
}

proctype Unloader() {
  byte i;
  do
  :: !going -> break
  :: atomic {
       going && !unloads ->
       i = 0;
       do
       :: i < CARRIERS && zone[i] == B && !rolls[i] && load[i] -> unloads = 1; break
       :: i < CARRIERS && !(zone[i] == B && !rolls[i] && load[i]) -> i++
       :: i == CARRIERS -> break
       od;
       i = 0
     }
  :: atomic {
       unloads ->
       unloads = 0;
       i = 0;
       do
       :: i < CARRIERS && zone[i] == B && !rolls[i] && load[i] -> load[i] = 0; stock_b++; break
       :: i < CARRIERS && !(zone[i] == B && !rolls[i] && load[i]) -> i++
       :: i == CARRIERS -> break
       od;
       i = 0
     }
  od
}

proctype ManagerA() {
  do
  :: !going -> break
  :: atomic { going -> said_a = stock_a }
  od
}

proctype ManagerB() {
  stock_b == BOXES;
  going = 0
}

init {
  byte i;
  atomic {
    for (i : 0 .. CARRIERS - 1) {
      zone[i] = 5 + i;
      run Carrier(i);
      run Motion(i)
    }
    run Loader();
    run Unloader();
    run ManagerA();
    run ManagerB()
  }
}
