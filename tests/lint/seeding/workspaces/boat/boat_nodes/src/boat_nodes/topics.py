THRUST = 'thrust'
DEPTH = 'sonar/depth'
WAYPOINT = 'waypoint'
