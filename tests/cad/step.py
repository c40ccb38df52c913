"""Reads STEP and IGES with OpenCASCADE."""

from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.IGESControl import IGESControl_Reader
from OCP.Quantity import Quantity_Color
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name, TDataStd_TreeNode
from OCP.TDF import TDF_Label, TDF_LabelSequence
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS
from OCP.XCAFDoc import XCAFDoc, XCAFDoc_ColorSurf, XCAFDoc_DocumentTool, XCAFDoc_Material, XCAFDoc_ShapeTool

# A single instance: a second one would be freed twice.
MATERIAL_OF = XCAFDoc.MaterialRefGUID_s()

ANALYTIC = {"Plane", "Cylinder", "Cone", "Sphere", "Torus"}


class Part:
    """Imported part, in mm."""

    def __init__(self, name, shape):
        self.name = name
        solids = list(_each(shape, TopAbs_SOLID))
        self.solids = len(solids)
        self.valid = all(BRepCheck_Analyzer(solid).IsValid() for solid in solids)
        self.closed = all(shell.Closed() for shell in _each(shape, TopAbs_SHELL))
        self.volume = volume(shape)
        self.surfaces = surfaces(shape)
        self.area = area(shape)
        self.color = False
        self.material = None
        self.density_kg_m3 = None


def _each(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def volume(shape):
    """Enclosed volume, mm^3."""
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties, 1e-9)
    return properties.Mass()


def area(shape):
    """Area of all faces, mm^2."""
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(shape, properties, 1e-9)
    return properties.Mass()


def surfaces(shape):
    """Kinds of the surfaces of all faces."""
    faces = (TopoDS.Face_s(face) for face in _each(shape, TopAbs_FACE))
    return [str(BRepAdaptor_Surface(face).GetType()).split("_")[-1] for face in faces]


def _name(label):
    name = TDataStd_Name()
    return name.Get().ToExtString() if label.FindAttribute(TDataStd_Name.GetID_s(), name) else ""


def read(path):
    """Name of the assembly, and its parts."""
    document = TDocStd_Document(TCollection_ExtendedString("cad"))
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.SetColorMode(True)
    reader.SetMatMode(True)
    assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"{path} cannot be read"
    assert reader.Transfer(document), f"{path} cannot be transferred"
    main = document.Main()
    shapes, colors = XCAFDoc_DocumentTool.ShapeTool_s(main), XCAFDoc_DocumentTool.ColorTool_s(main)
    roots = TDF_LabelSequence()
    shapes.GetFreeShapes(roots)
    assert roots.Length() == 1, f"{path} has {roots.Length()} roots"
    root = roots.Value(1)
    assert XCAFDoc_ShapeTool.IsAssembly_s(root), f"{path} is not an assembly"
    components = TDF_LabelSequence()
    XCAFDoc_ShapeTool.GetComponents_s(root, components, False)
    parts = []
    for i in range(1, components.Length() + 1):
        product = TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(components.Value(i), product)
        shape = XCAFDoc_ShapeTool.GetShape_s(components.Value(i))
        part = Part(_name(product), shape)
        solids = list(_each(XCAFDoc_ShapeTool.GetShape_s(product), TopAbs_SOLID))
        color = Quantity_Color()
        part.color = all(colors.GetColor(solid, XCAFDoc_ColorSurf, color) for solid in solids)
        if product.IsAttribute(MATERIAL_OF):
            node, material = TDataStd_TreeNode(), XCAFDoc_Material()
            assert product.FindAttribute(MATERIAL_OF, node)
            assert node.Father().Label().FindAttribute(XCAFDoc_Material.GetID_s(), material)
            part.material = material.GetName().ToCString()
            # in g/mm^3 as read
            part.density_kg_m3 = material.GetDensity() * 1e6
        parts.append(part)
    return _name(root), parts


def read_iges(path):
    """Kinds and total area of the surfaces."""
    reader = IGESControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"{path} cannot be read"
    reader.TransferRoots()
    shape = reader.OneShape()
    return surfaces(shape), area(shape)
