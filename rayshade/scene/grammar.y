/* The grammar of the scene language [rayshade4/1 s.3]. Actions only hand on what was read; what it means
   is in parser_context.h and the classes named there. An action that needs no look-ahead runs before the next
   token is read: the line numbers of messages depend on it.

   After a syntax error the parser drops what it has of the item, skips to a word with which an item may
   begin, and goes on. */
%define api.pure full
%define api.prefix {rayshade_}
%define api.value.type {rayshade::ParserValue}
%param {rayshade::ParserContext* c}
%expect 0

%code requires {
#include "rayshade/scene/parser_value.h"
namespace rayshade {
class ParserContext;
}
// Values are copied as bytes when the parser's stack grows.
#define RAYSHADE_STYPE_IS_TRIVIAL 1
}

%code {
#include "rayshade/scene/parser_context.h"

using namespace rayshade;

static int yylex(ParserValue* value, ParserContext* c) { return c->lexer.Next(value); }
static void yyerror(ParserContext* c, const char* text) { c->SyntaxError(text); }
}

%token <number> T_NUMBER T_SIGNED
%token <name> T_NAME T_PATH
%token T_STRANGE
%token T_SURFACE "surface" T_APPLYSURF "applysurf" T_NAME_OBJECT "name" T_PLANE "plane" T_DISC "disc"
   T_SPHERE "sphere" T_TRIANGLE "triangle" T_TRIANGLEUV "triangleuv" T_POLY "poly" T_BOX "box"
   T_CYLINDER "cylinder" T_CONE "cone" T_TORUS "torus" T_BLOB "blob" T_HEIGHTFIELD "heightfield"
   T_LIST "list" T_GRID "grid" T_UNION "union" T_INTERSECT "intersect" T_DIFFERENCE "difference"
   T_OBJECT "object" T_EYEP "eyep" T_LOOKP "lookp" T_UP "up" T_FOV "fov" T_APERTURE "aperture"
   T_FOCALDIST "focaldist" T_EYESEP "eyesep" T_SCREEN "screen" T_WINDOW "window" T_CROP "crop"
   T_SHUTTER "shutter" T_FRAMES "frames" T_FRAMELENGTH "framelength" T_STARTTIME "starttime"
   T_SAMPLE "sample" T_FILTER "filter" T_CONTRAST "contrast" T_CUTOFF "cutoff" T_MAXDEPTH "maxdepth"
   T_BACKGROUND "background" T_SHADOWTRANSP "shadowtransp" T_OUTFILE "outfile" T_REPORT "report"
   T_PRINT "print" T_DEFINE "define" T_LIGHT "light" T_ATMOSPHERE "atmosphere" T_END "end"
   T_JITTER "jitter" T_NOJITTER "nojitter" T_GAUSS "gauss" T_VERBOSE "verbose" T_QUIET "quiet"
   T_AMBIENT "ambient" T_POINT "point" T_DIRECTIONAL "directional" T_EXTENDED "extended"
   T_SPOT "spot" T_AREA "area" T_NOSHADOW "noshadow" T_MIST "mist" T_FOG "fog" T_FOGDECK "fogdeck"
   T_CURSURF "cursurf" T_DIFFUSE "diffuse" T_SPECULAR "specular" T_SPECPOW "specpow" T_BODY "body"
   T_EXTINCT "extinct" T_REFLECT "reflect" T_TRANSP "transp" T_TRANSLU "translu" T_INDEX "index"
   T_SCALE "scale" T_TRANSLATE "translate" T_ROTATE "rotate" T_TRANSFORM "transform"
   T_TEXTURE "texture" T_CHECKER "checker" T_BLOTCH "blotch" T_BUMP "bump" T_MARBLE "marble"
   T_FBM "fbm" T_FBMBUMP "fbmbump" T_WOOD "wood" T_GLOSS "gloss" T_CLOUD "cloud" T_SKY "sky"
   T_STRIPE "stripe" T_IMAGE "image" T_WINDY "windy" T_MOUNT "mount" T_COMPONENT "component"
   T_TILE "tile" T_TEXTSURF "textsurf" T_RANGE "range" T_SMOOTH "smooth" T_MAP "map" T_UV "uv"
   T_CYLINDRICAL "cylindrical" T_PLANAR "planar" T_SPHERICAL "spherical"

%type <number> num
%type <integer> int map_kind component
%type <value> anum any_anum expr
%type <triple> vec intensity
%type <name> filename
%type <surface> surf surf_opt

%left '+' '-'
%left '*' '/' '%'
%precedence SIGN
%right '^'

%%

input: items ;

items:
    %empty
  | items item             { c->EndItem(); }
  | items error            { if ((yychar = c->Recover(yychar, false)) != 0) yyerrok; }
  ;

body:
    %empty
  | body body_item         { c->EndItem(); }
  | body error             { if ((yychar = c->Recover(yychar, true)) != 0) yyerrok; }
  ;

item: view | setting | light | air | body_item ;

body_item:
    instance
  | T_SURFACE T_NAME                              { c->surfaces.Define($2, c->surfaces.Blank()); }
  | T_SURFACE T_NAME surf                         { c->surfaces.Define($2, $3); }
  | T_APPLYSURF surf                              { c->surfaces.Apply($2); }
  | T_NAME_OBJECT T_NAME                          { c->objects.OpenDefinition(); }
    instance                                      { c->objects.CloseDefinition($2); }
  ;

/* ---- numbers ---- */

num:
    T_NUMBER                                      { $$ = c->symbols.Finite($1); }
  | T_SIGNED                                      { $$ = c->symbols.Finite($1); }
  | '+' T_NUMBER                                  { $$ = c->symbols.Finite($2); }
  | '-' T_NUMBER                                  { $$ = c->symbols.Finite(-$2); }
  | '(' expr ')'                                  { $$ = c->symbols.Finite(c->symbols.Constant($2)); }
  ;

int: num                                          { $$ = TruncateToInt($1); } ;

anum: any_anum                                    { $$ = $1; c->symbols.CheckFinite($1); } ;

any_anum:
    T_NUMBER                                      { $$ = c->KeepNumber($1); }
  | T_SIGNED                                      { $$ = c->KeepNumber($1); }
  | '+' T_NUMBER                                  { $$ = c->KeepNumber($2); }
  | '-' T_NUMBER                                  { $$ = c->KeepNumber(-$2); }
  | '(' expr ')'                                  { $$ = $2; }
  ;

vec: num num num                                  { $$ = c->Keep(Triple{$1, $2, $3}); } ;

intensity:
    num                                           { $$ = c->Keep(Triple{$1, $1, $1}); }
  | num num num                                   { $$ = c->Keep(Triple{$1, $2, $3}); }
  ;

filename: T_NAME | T_PATH ;

expr:
    T_NUMBER                                      { $$ = c->KeepNumber($1); }
  | T_NAME                                        { $$ = c->Keep(c->symbols.Variable($1)); }
  | '(' expr ')'                                  { $$ = $2; }
  | expr '+' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kAdd, {$1, $3})); }
  | expr '-' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kSubtract, {$1, $3})); }
  | expr '*' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kMultiply, {$1, $3})); }
  | expr '/' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kDivide, {$1, $3})); }
  | expr '%' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kRemainder, {$1, $3})); }
  | expr '^' expr                                 { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kPower, {$1, $3})); }
  | '-' expr %prec SIGN                           { $$ = c->Keep(c->symbols.Operate(ExpressionOp::kNegate, {$2})); }
  | '+' expr %prec SIGN                           { $$ = $2; }
  | T_NAME '(' expr ')'                           { $$ = c->Keep(c->symbols.Call($1, {$3})); }
  | T_NAME '(' expr ',' expr ')'                  { $$ = c->Keep(c->symbols.Call($1, {$3, $5})); }
  | T_NAME '(' expr ',' expr ',' expr ')'         { $$ = c->Keep(c->symbols.Call($1, {$3, $5, $7})); }
  | T_NAME '(' expr ',' expr ',' expr ',' expr ')'
                                                  { $$ = c->Keep(c->symbols.Call($1, {$3, $5, $7, $9})); }
  | T_NAME '(' expr ',' expr ',' expr ',' expr ',' expr ')'
                                                  { $$ = c->Keep(c->symbols.Call($1, {$3, $5, $7, $9, $11})); }
  ;

/* ---- view ---- */

view:
    T_EYEP vec                                    { c->settings.eye = $2; c->objects.IgnoreTransforms(); }
    xforms
  | T_LOOKP vec                                   { c->settings.look = $2; }
  | T_UP vec                                      { c->settings.up = $2; }
  | T_FOV num                                     { c->settings.hfov = $2; c->settings.vfov.reset(); }
  | T_FOV num num                                 { c->settings.hfov = $2; c->settings.vfov = $3; }
  | T_SCREEN int int                              { c->settings.width = $2; c->settings.height = $3; }
  | T_WINDOW int int int int                      { if (!c->settings.window) c->settings.window = {{$2, $3, $4, $5}}; }
  | T_CROP num num num num                        { c->settings.crop = {$2, $3, $4, $5}; }
  | T_APERTURE num                                { c->settings.aperture = $2; }
  | T_FOCALDIST num                               { c->settings.focal_distance = $2; }
  | T_EYESEP num                                  { c->settings.eye_separation = $2; }
  | T_SHUTTER num                                 { c->settings.shutter = $2; }
  | T_FRAMELENGTH num                             { c->settings.frame_length = $2; }
  | T_STARTTIME num                               { c->settings.start_time = $2; }
  | T_FRAMES int                                  { c->settings.frames = $2; }
  ;

/* ---- settings ---- */

setting:
    T_SAMPLE int                                  { c->settings.samples = $2; }
    jitter
  | T_FILTER filter_kind
  | T_FILTER filter_kind num                      { c->settings.filter_width = $3; }
  | T_CONTRAST vec                                { c->settings.contrast = $2; }
  | T_CUTOFF intensity                            { c->settings.cutoff = $2; }
  | T_MAXDEPTH int                                { c->settings.max_depth = $2; }
  | T_BACKGROUND vec                              { c->settings.background = $2; }
  | T_SHADOWTRANSP                                { c->settings.shadow_transparency = !c->settings.shadow_transparency; }
  | T_OUTFILE filename                            { c->NameOutput($2); }
  | T_REPORT report_verbose report_quiet report_frequency report_file
  | T_DEFINE T_NAME anum                          { c->symbols.Define($2, $3); }
  | T_PRINT any_anum                              { c->Print(c->symbols.Constant($2)); }
  ;
jitter:
    %empty
  | T_JITTER                                      { c->settings.jitter = true; }
  | T_NOJITTER                                    { c->settings.jitter = false; }
  ;
filter_kind:
    T_BOX                                         { c->settings.filter = FilterKind::kBox; }
  | T_GAUSS                                       { c->settings.filter = FilterKind::kGauss; }
  ;
report_verbose:   %empty | T_VERBOSE              { c->SetVerbose(); } ;
report_quiet:     %empty | T_QUIET                { c->SetQuiet(); } ;
report_frequency: %empty | int                    { c->SetReportFrequency($1); } ;
report_file:      %empty | filename               { c->NameReport($1); } ;

/* ---- lights and air ---- */

light:
    T_LIGHT intensity T_AMBIENT                   { c->settings.ambient_light = $2; }
  | T_LIGHT intensity source                      { c->lights.Add($2, false); }
  | T_LIGHT intensity source T_NOSHADOW           { c->lights.Add($2, true); }
  ;
source:
    T_POINT vec                                   { c->lights.SetPoint($2); }
  | T_DIRECTIONAL vec                             { c->lights.SetDirectional($2); }
  | T_EXTENDED num vec                            { c->lights.SetExtended($2, $3); }
  | T_SPOT vec vec num                            { c->lights.SetSpot({$2, $3, $4, 0, 0}); }
  | T_SPOT vec vec num num num                    { c->lights.SetSpot({$2, $3, $4, $5, $6}); }
  | T_AREA vec vec int vec int                    { c->lights.SetArea({$2, $3, $4, $5, $6}); }
  ;

air:
    T_ATMOSPHERE                                  { c->air.Begin(); }
    effects                                       { c->air.End(); }
  | T_ATMOSPHERE int                              { c->air.Begin(); c->air.SetIndex($2); }
    effects                                       { c->air.End(); }
  ;
effects: %empty | effects effect ;
effect:
    T_MIST vec vec num num                        { c->air.Add(Mist{$2, $3, $4, $5}); }
  | T_FOG vec vec                                 { c->air.Add(Fog{$2, $3}); }
  | T_FOGDECK num num vec num int vec vec         { c->air.Add(FogDeck{$2, $3, $4, $5, $6, $7, $8}); }
  ;

/* ---- surfaces ---- */

surf_opt:
    %empty                                        { $$ = c->surfaces.current(); }
  | surf
  ;
surf:
    T_NAME                                        { $$ = c->surfaces.Named($1); }
  | T_CURSURF                                     { $$ = c->surfaces.CurrentOrDefault(); }
  | changed                                       { $$ = c->surfaces.Finish(); }
  ;
changed:
    { c->surfaces.StartBlank(); } attribute
  | T_NAME { c->surfaces.StartFrom(c->surfaces.Named($1)); } attribute
  | T_CURSURF { c->surfaces.StartFrom(c->surfaces.CurrentOrDefault()); } attribute
  | changed attribute
  ;
attribute:
    T_AMBIENT vec                                 { c->surfaces.building().ambient = $2; }
  | T_DIFFUSE vec                                 { c->surfaces.building().diffuse = $2; }
  | T_SPECULAR vec                                { c->surfaces.building().specular = $2; }
  | T_SPECPOW num                                 { c->surfaces.building().specpow = $2; }
  | T_BODY vec                                    { c->surfaces.building().body = $2; }
  | T_EXTINCT num                                 { c->surfaces.building().extinct = $2; }
  | T_TRANSP num                                  { c->surfaces.building().transp = $2; }
  | T_REFLECT num                                 { c->surfaces.building().reflect = $2; }
  | T_INDEX num                                   { c->surfaces.building().index = $2; }
  | T_TRANSLU num vec num                         { c->surfaces.SetTranslucency($2, $3, $4); }
  | T_NOSHADOW                                    { c->surfaces.building().noshadow = true; }
  ;

/* ---- objects ---- */

instance: shape xforms textures                   { c->objects.Place(); } ;

shape:
    T_PLANE surf_opt vec vec                      { c->objects.Set($2, PlaneSpec{$3, $4}); }
  | T_DISC surf_opt num vec vec                   { c->objects.Set($2, DiscSpec{$3, $4, $5}); }
  | T_SPHERE surf_opt num vec                     { c->objects.Set($2, SphereSpec{$3, $4}); }
  | T_BOX surf_opt vec vec                        { c->objects.Set($2, BoxSpec{$3, $4}); }
  | T_CYLINDER surf_opt num vec vec               { c->objects.Set($2, CylinderSpec{$3, $4, $5}); }
  | T_CONE surf_opt num vec num vec               { c->objects.Set($2, ConeSpec{$3, $4, $5, $6}); }
  | T_TORUS surf_opt num num vec vec              { c->objects.Set($2, TorusSpec{$3, $4, $5, $6}); }
  | T_TRIANGLE surf_opt vec vec vec               { c->objects.SetTriangle($2, {$3, $4, $5}); }
  | T_TRIANGLE surf_opt vec vec vec vec vec vec   { c->objects.SetPhongTriangle($2, {$3, $5, $7}, {$4, $6, $8}); }
  | T_TRIANGLEUV surf_opt vec vec num num vec vec num num vec vec num num
                                                  { c->objects.SetTriangleUv($2, {$3, $7, $11}, {$4, $8, $12}, {$5, $6, $9, $10, $13, $14}); }
  | T_POLY surf_opt points                        { c->objects.SetPolygon($2); }
  | T_BLOB surf_opt num balls                     { c->objects.SetBlob($2, $3); }
  | T_HEIGHTFIELD filename                        { c->objects.SetHeightfield(kNoSurface, $2); }
  | T_HEIGHTFIELD surf filename                   { c->objects.SetHeightfield($2, $3); }
  | T_OBJECT T_NAME                               { c->objects.SetInstance(c->surfaces.current(), $2); }
  | T_OBJECT surf T_NAME                          { c->objects.SetInstance($2, $3); }
  | aggregate body T_END                          { c->objects.CloseAggregate(); }
  ;
points: %empty | points vec                       { c->objects.AddPoint($2); } ;
balls:  %empty | balls num num vec                { c->objects.AddBall($2, $3, $4); } ;
aggregate:
    T_LIST                                        { c->objects.OpenAggregate(AggregateKind::kList); }
  | T_GRID int int int                            { c->objects.OpenGrid($2, $3, $4); }
  | T_UNION                                       { c->objects.OpenAggregate(AggregateKind::kUnion); }
  | T_INTERSECT                                   { c->objects.OpenAggregate(AggregateKind::kIntersect); }
  | T_DIFFERENCE                                  { c->objects.OpenAggregate(AggregateKind::kDifference); }
  ;

xforms: %empty | xforms xform ;
xform:
    T_SCALE anum anum anum                        { c->objects.Transform(TransformKind::kScale, {$2, $3, $4}); }
  | T_TRANSLATE anum anum anum                    { c->objects.Transform(TransformKind::kTranslate, {$2, $3, $4}); }
  | T_ROTATE anum anum anum anum                  { c->objects.Transform(TransformKind::kRotate, {$2, $3, $4, $5}); }
  | T_TRANSFORM anum anum anum anum anum anum anum anum anum
                                                  { c->objects.Transform(TransformKind::kMatrix, {$2, $3, $4, $5, $6, $7, $8, $9, $10, {}, {}, {}}); }
  | T_TRANSFORM anum anum anum anum anum anum anum anum anum anum anum anum
                                                  { c->objects.Transform(TransformKind::kMatrix, {$2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13}); }
  ;

/* ---- textures ---- */

textures: %empty | textures texture ;
texture: T_TEXTURE texture_kind xforms            { c->objects.EndTexture(); } ;
texture_kind:
    T_CHECKER surf                                { c->objects.BeginTexture(CheckerSpec{$2}); }
  | T_BLOTCH num surf                             { c->objects.BeginTexture(BlotchSpec{$2, $3}); }
  | T_BUMP num                                    { c->objects.BeginTexture(BumpSpec{$2}); }
  | T_GLOSS num                                   { c->objects.BeginTexture(GlossSpec{$2}); }
  | T_WOOD                                        { c->objects.BeginTexture(WoodSpec{}); }
  | T_MARBLE                                      { c->objects.BeginTexture(MarbleSpec{}); }
  | T_MARBLE filename                             { c->objects.BeginTexture(MarbleSpec{c->ReadMap($2)}); }
  | T_FBM num num num num int num                 { c->objects.BeginTexture(FbmSpec{$2, $3, $4, $5, $6, $7, nullptr}); }
  | T_FBM num num num num int num filename        { c->objects.BeginTexture(FbmSpec{$2, $3, $4, $5, $6, $7, c->ReadMap($8)}); }
  | T_FBMBUMP num num num num int                 { c->objects.BeginTexture(FbmBumpSpec{$2, $3, $4, $5, $6}); }
  | T_CLOUD num num num int num num num           { c->objects.BeginTexture(CloudSpec{$2, $3, $4, $5, $6, $7, $8}); }
  | T_SKY num num num int num num                 { c->objects.BeginTexture(SkySpec{$2, $3, $4, $5, $6, $7}); }
  | T_STRIPE surf num num                         { c->objects.BeginTexture(StripeSpec{$2, $3, $4, {}}); }
  | T_STRIPE surf num num mapping                 { c->objects.BeginTexture(StripeSpec{$2, $3, $4, c->mapping}); }
  | T_WINDY num num num num int num num num       { c->objects.BeginTexture(WindySpec{$2, $3, $4, $5, $6, $7, $8, $9}); }
  | T_MOUNT filename num num                      { c->objects.BeginTexture(MountSpec{c->ReadMap($2), $3, $4}); }
  | T_IMAGE filename                              { c->BeginImage($2); }
    image_options                                 { c->objects.BeginTexture(c->image); }
  ;
image_options: %empty | image_options image_option ;
image_option:
    T_COMPONENT component                         { c->SetComponent(static_cast<ImageComponent>($2)); }
  | T_TILE num num                                { c->image.tile_u = $2; c->image.tile_v = $3; }
  | T_TEXTSURF surf                               { c->image.surface = $2; }
  | T_RANGE num num                               { c->image.range_high = $2; c->image.range_low = $3; }
  | T_SMOOTH                                      { c->image.smooth = true; }
  | mapping                                       { c->image.mapping = c->mapping; }
  ;
component:
    T_AMBIENT                                     { $$ = static_cast<int>(ImageComponent::kAmbient); }
  | T_DIFFUSE                                     { $$ = static_cast<int>(ImageComponent::kDiffuse); }
  | T_BODY                                        { $$ = static_cast<int>(ImageComponent::kBody); }
  | T_SPECULAR                                    { $$ = static_cast<int>(ImageComponent::kSpecular); }
  | T_REFLECT                                     { $$ = static_cast<int>(ImageComponent::kReflect); }
  | T_TRANSP                                      { $$ = static_cast<int>(ImageComponent::kTransp); }
  | T_SPECPOW                                     { $$ = static_cast<int>(ImageComponent::kSpecpow); }
  | T_BUMP                                        { $$ = static_cast<int>(ImageComponent::kBump); }
  | T_INDEX                                       { $$ = static_cast<int>(ImageComponent::kIndex); }
  ;
mapping:
    T_MAP T_UV                                    { c->mapping = {}; }
  | T_MAP map_kind                                { c->mapping = {static_cast<MappingKind>($2), false, {}, {}, {}}; }
  | T_MAP map_kind vec vec vec                    { c->mapping = {static_cast<MappingKind>($2), true, $3, $4, $5}; }
  ;
map_kind:
    T_SPHERICAL                                   { $$ = static_cast<int>(MappingKind::kSpherical); }
  | T_CYLINDRICAL                                 { $$ = static_cast<int>(MappingKind::kCylindrical); }
  | T_PLANAR                                      { $$ = static_cast<int>(MappingKind::kPlanar); }
  ;

%%
