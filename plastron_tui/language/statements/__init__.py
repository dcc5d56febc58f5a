"""The statements of the language, each declared once."""

# In the order in which menus and the language page have them.
# isort: off
from .nodes import CreateNode, Load
from .topics import CreateMessage, Publish, StopPublishing, Subscribe, Unsubscribe
from .services import ClientRequests, ProvidesService, StopRequest, StopService
from .actions import ProvidesAction, SendsGoal, StopAction, StopGoal
from .parameters import HasParameter, NoLongerHasParameter
from .timers import Repeats, StopRepeating
from .names import Rename
from .files import GenerateNode
# isort: on

__all__ = [
    "ClientRequests",
    "CreateMessage",
    "CreateNode",
    "GenerateNode",
    "HasParameter",
    "Load",
    "NoLongerHasParameter",
    "ProvidesAction",
    "ProvidesService",
    "Publish",
    "Rename",
    "Repeats",
    "SendsGoal",
    "StopAction",
    "StopGoal",
    "StopPublishing",
    "StopRepeating",
    "StopRequest",
    "StopService",
    "Subscribe",
    "Unsubscribe",
]
