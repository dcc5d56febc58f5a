"""What stays of rospy and of Python 2 where nobody looks at it, brought to rclpy."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, count_marks, ported

HEAD = "import rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('n')\n"
LOOP = f"{MARK}create_rate in a loop\n"
LONG = "'" + "x" * 60 + "'"
LINES = [
    ("x = raw_input('a')", "x = input('a')"),
    ("def raw_input(x): pass\nraw_input(1)", "def raw_input(x): pass\nraw_input(1)"),
    ("for i in xrange(3): pass", "for i in range(3): pass"),
    ("for a, b in x.iteritems(): pass", "for a, b in x.items(): pass"),
    ("x = six.iteritems(y)", "x = six.iteritems(y)"),
    ("x = y.has_key(1)", "x = 1 in y"),
    ("if not y.z.has_key(a): pass", "if a not in y.z: pass"),
    ("x = y.has_key(a) == z", "x = (a in y) == z"),
    ("x = y.has_key(a or b)", f"{MARK}.has_key\nx = y.has_key(a or b)"),
    ("print 'a', b", "print('a', b)"),
    ("print 'a',", "print('a', end=' ')"),
    ("print >>f, x", "print(x, file=f)"),
    ("print >>f, x,", "print(x, end=' ', file=f)"),
    ("print >>f", "print(file=f)"),
    ("print 'a %s' % \\\n    b, \\\n    c", "print('a %s' % \\\n    b, \\\n    c)"),
    ("print 'a'; print; print ('b')", "print('a'); print(); print ('b')"),
    ("print 1\nprint ('a %s') % b", "print(1)\nprint(('a %s') % b)"),
    ("print 1\nprint ('a'), b, # c", "print(1)\nprint(('a'), b, end=' ') # c"),
    ("print 1\nprint (a)[0]", "print(1)\nprint((a)[0])"),
    ("print 1\nprint -a", "print(1)\nprint(-a)"),
    ("print ('a'), b\nprint", "print ('a'), b\nprint"),
    ("print 'a', rospy.get_name()", "print('a', node.get_fully_qualified_name())"),
    ("print rospy.get_name(),", "print(node.get_fully_qualified_name(), end=' ')"),
    ("try: x()\nexcept X, e: pass", "try: x()\nexcept X as e: pass"),
    ("try: x()\nexcept (X, Y), e: pass", "try: x()\nexcept (X, Y) as e: pass"),
    ("raise X, 'a %s' % b", "raise X('a %s' % b)"),
    (
        "raise rospy.ROSException, 'a'",
        f"{MARK}rospy.ROSException\nraise rospy.ROSException('a')",
    ),
    ("exec a", "exec(a)"),
    ("exec a in c", "exec(a, c)"),
    ("x = y.keys()[0]", "x = list(y.keys())[0]"),
    ("x = map(f, y)[1:]", "x = list(map(f, y))[1:]"),
    ("x = y.items('a')[0]", "x = y.items('a')[0]"),
    ("def map(x): pass\nmap(1)[0]", "def map(x): pass\nmap(1)[0]"),
    ("print len(a) / 2", "print(len(a) // 2)"),
    ("print a / 2, len(a) / 2.0", "print(a / 2, len(a) / 2.0)"),
    ("x = len(a) / 2", "x = len(a) / 2"),
    ("if a:\n        b()\n\tc()", "if a:\n        b()\n        c()"),
    ("if a:\n    if b:\n\tx = '''\n\ty'''", "if a:\n    if b:\n        x = '''\n\ty'''"),
    ("if a:\n\tb()", "if a:\n\tb()"),
    ("if a <> 0777: x = 10L", "if a != 0o777: x = 10"),
    ("raise rospy.ROSException('a')", "raise ROSException('a')"),
    ("rospy.Rate(9).sleep()", "node.create_rate(9).sleep()"),
    (
        "while x:\n    rospy.Rate(9).sleep()",
        f"while x:\n    {LOOP}    node.create_rate(9).sleep()",
    ),
    ("for x in f(rospy.Rate(9)): pass", "for x in f(node.create_rate(9)): pass"),
    (
        "while x:\n    def f():\n        return rospy.Rate(9)",
        "while x:\n    def f():\n        return node.create_rate(9)",
    ),
    (
        "p = rospy.Publisher('/x/' + a, String, queue_size=1)",
        "p = node.create_publisher(String, '/x/' + a, 1)",
    ),
    (
        "p = rospy.Publisher('/{}/x'.format(a), String, queue_size=1)",
        "p = node.create_publisher(String, '/{}/x'.format(a), 1)",
    ),
    (
        "p = rospy.Publisher(('/%s' % a), String, queue_size=1)",
        "p = node.create_publisher(String, ('/%s' % a), 1)",
    ),
    (
        "p = rospy.Publisher(f'/{a}', String, queue_size=1)",
        "p = node.create_publisher(String, f'/{a}', 1)",
    ),
    (
        "p = rospy.Publisher('~' + a, String, queue_size=1)",
        f"{MARK}the name '~' + a\np = node.create_publisher(String, '~' + a, 1)",
    ),
    (
        "p = rospy.Publisher('x/' + a, String, queue_size=1)",
        "p = node.create_publisher(String, 'x/' + a, 1)",
    ),
    (
        "def f(m): print(m._connection_header)",
        f"{MARK}._connection_header\ndef f(m): print(m._connection_header)",
    ),
    ("rospy.ServiceProxy('s', X).uri", f"{MARK}.uri\nnode.create_client(X, 's').uri"),
    (
        "p = rospy.Publisher('/x', String)\nprint(p.name)",
        f"p = node.create_publisher(String, '/x', 10)\n{MARK}.name\nprint(p.name)",
    ),
    (
        f"x = '~'\np = rospy.Publisher(a + {LONG}, String, queue_size=1)",
        f"x = '~'\n{MARK}the name that is made here\n"
        f"p = node.create_publisher(\n    String, a + {LONG}, 1\n)",
    ),
]


@pytest.mark.parametrize(("before", "after"), LINES)
def test_a_line_of_rospy(before: str, after: str) -> None:
    text, _ = ported(f"{HEAD}{before}\n", "rospy")
    ast.parse(text)
    assert text.endswith(f"\n{after}\n")
    assert count_marks(text) == after.count(MARK)


HELP = [
    ("rospy", "import tf.transformations", "`tf_transformations`"),
    ("rospy", "import tf2_ros", "its listener and broadcasters take the node"),
    ("rospy", "x = rospy.resolve_name('y')", "`node.resolve_topic_name(name)`"),
    ("rclpy", "import ament_index_python", "`rospkg.RosPack().get_path(package)`"),
    ("rclpy", "x = rclpy.task.Future()", "rospy has no futures: a client gives the answer itself"),
]


@pytest.mark.parametrize(("library", "line", "remedy"), HELP)
def test_what_to_write_instead(library: str, line: str, remedy: str) -> None:
    made = {
        "rospy": "rospy.init_node('n')\n",
        "rclpy": "rclpy.init()\nnode = rclpy.create_node('n')\n",
    }
    _, found = ported(f"import {library}\n{made[library]}{line}\n", library)
    assert remedy in [each.help for each in found]
