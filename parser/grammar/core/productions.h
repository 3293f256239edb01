#pragma once

#include "parser/form/form.h"

/// What each block reads, braces included but for its keyword; and what several blocks share.
namespace parser {

Production scene_text();
Production declared_value();
// Of what is read without rules.
Production color_form();
Production directive();
Production function_block();
Production function_pattern_type();
Production function_value();
Production number_form();
Production pair_form();
Production rest_of_directive();
Production spline_block();
Production text_form();
Production vector_form();
Production vector4_form();
// parser/grammar/core
Production transformation();
Production transform_block();
// parser/grammar/scene
Production background_block();
Production bokeh_block();
Production camera_block();
Production default_block();
Production density_block();
Production finish_subsurface_block();
Production fog_block();
Production global_photons_block();
Production global_radiosity_block();
Production global_settings_block();
Production global_subsurface_block();
Production light_photons_block();
Production light_source_block();
Production media_block();
Production mesh_camera_block();
Production object_photons_block();
Production object_radiosity_block();
Production old_setting();
Production rainbow_block();
Production sky_sphere_block();
// parser/grammar/textures
Production color_map_block();
Production density_map_block();
Production finish_block();
Production image_block();
Production image_map_block();
Production interior_block();
Production material_block();
Production material_map_block();
Production normal_body();
Production normal_block();
Production normal_map_block();
Production pattern_type();
Production pattern_modifier();
Production pigment_body();
Production pigment_block();
Production pigment_map_block();
Production density_body();
Production slope_map_block();
Production texture_body();
Production texture_block();
Production texture_map_block();
// parser/grammar/objects
Production component_modifier();
Production mesh_block();
Production mesh2_block();
Production any_object();
Production object_modifier();

}  // namespace parser
