"""The statements of the language, each declared once."""

from ..declaration import DECLARATIONS

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
from .types import CreateMessageType, CreateServiceType, CreateActionType, LoadType
from .types import HasField, NoLongerHasField, DropType, GenerateType
from .packages import CreatePackage, LoadPackage, Contains, NoLongerContains, GeneratePackage
from .launches import CreateLaunch, LoadLaunch, HasArgument, NoLongerHasArgument, Starts
from .launches import NoLongerStarts, Includes, NoLongerIncludes, GenerateLaunch
from .robots import CreateRobot, LoadRobot, HasLink, NoLongerHasLink, HasJoint, NoLongerHasJoint
from .robots import LimitsJoint, GenerateRobot
# isort: on

__all__ = [
    "DECLARATIONS",
    "ClientRequests",
    "Contains",
    "CreateActionType",
    "CreateLaunch",
    "CreateMessage",
    "CreateMessageType",
    "CreateNode",
    "CreatePackage",
    "CreateRobot",
    "CreateServiceType",
    "DropType",
    "GenerateLaunch",
    "GenerateNode",
    "GeneratePackage",
    "GenerateRobot",
    "GenerateType",
    "HasArgument",
    "HasField",
    "HasJoint",
    "HasLink",
    "HasParameter",
    "Includes",
    "LimitsJoint",
    "Load",
    "LoadLaunch",
    "LoadPackage",
    "LoadRobot",
    "LoadType",
    "NoLongerContains",
    "NoLongerHasArgument",
    "NoLongerHasField",
    "NoLongerHasJoint",
    "NoLongerHasLink",
    "NoLongerHasParameter",
    "NoLongerIncludes",
    "NoLongerStarts",
    "ProvidesAction",
    "ProvidesService",
    "Publish",
    "Rename",
    "Repeats",
    "SendsGoal",
    "Starts",
    "StopAction",
    "StopGoal",
    "StopPublishing",
    "StopRepeating",
    "StopRequest",
    "StopService",
    "Subscribe",
    "Unsubscribe",
]
