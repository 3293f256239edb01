;;; pov-scene-mode.el --- Scenes of POV-Ray's language, with whittle's language server  -*- lexical-binding: t; -*-

;; README.md says how it is installed.

;;; Commentary:

;; A small mode: comments, texts, reserved words and names are told apart, lines are indented by their brackets and
;; directives.  All that needs to know the language is asked of `whittle lsp' through eglot.

;;; Code:

;; begin of words (keywords.py)
(defconst pov-scene-directives
  '(
    "break" "case" "debug" "declare" "default" "else" "elseif" "end" "error" "fclose" "fopen" "for"
    "if" "ifdef" "ifndef" "include" "local" "macro" "range" "read" "render" "statistics" "switch"
    "undef" "version" "warning" "while" "write"))

(defconst pov-scene-functions
  '(
    "abs" "acos" "acosh" "asc" "asin" "asinh" "atan" "atan2" "atanh" "bitwise_and" "bitwise_or"
    "bitwise_xor" "ceil" "chr" "clock" "clock_on" "concat" "cos" "cosh" "datetime" "defined"
    "degrees" "dimension_size" "dimensions" "div" "exp" "false" "file_exists" "floor" "inside" "int"
    "ln" "log" "max" "max_extent" "min" "min_extent" "mod" "no" "now" "off" "on" "pi" "pow" "prod"
    "radians" "rand" "seed" "select" "sin" "sinh" "sqrt" "str" "strcmp" "strlen" "strlwr" "strupr"
    "substr" "sum" "t" "tan" "tanh" "tau" "trace" "true" "val" "vaxis_rotate" "vcross" "vdot"
    "version" "vlength" "vnormalize" "vrotate" "vstr" "vturbulence" "x" "y" "yes" "z"))

(defconst pov-scene-words
  '(
    "aa_level" "aa_threshold" "absorption" "accuracy" "adaptive" "adc_bailout" "agate" "agate_turb"
    "albedo" "all" "all_intersections" "alpha" "altitude" "always_sample" "ambient" "ambient_light"
    "angle" "anisotropy" "aoi" "aperture" "append" "arc_angle" "area_illumination" "area_light"
    "array" "ascii" "assumed_gamma" "autostop" "average" "b_spline" "background" "bezier_spline"
    "bicubic_patch" "black_hole" "blend_gamma" "blend_mode" "blob" "blue" "blur_samples" "bmp"
    "bokeh" "bounded_by" "box" "boxed" "bozo" "break" "breakpoint" "brick" "brick_size" "brightness"
    "brilliance" "bt2020" "bt709" "bump_map" "bump_size" "bumps" "camera" "case" "caustics" "cells"
    "charset" "checker" "circular" "clipped_by" "cmap" "collect" "color" "color_map" "colour"
    "colour_map" "component" "composite" "cone" "confidence" "conic_sweep" "conserve_energy"
    "contained_by" "control0" "control1" "coords" "count" "crackle" "crand" "cube" "cubic"
    "cubic_spline" "cubic_wave" "cutaway_textures" "cylinder" "cylindrical" "debug" "declare"
    "default" "density" "density_file" "density_map" "dents" "deprecated" "df3" "dictionary"
    "difference" "diffuse" "direction" "disc" "dispersion" "dispersion_samples" "dist_exp"
    "distance" "distance_maximum" "double_illuminate" "dtag" "eccentricity" "else" "elseif"
    "emission" "end" "error" "error_bound" "evaluate" "expand_thresholds" "exponent" "exr"
    "exterior" "extinction" "face_indices" "facets" "fade_color" "fade_colour" "fade_distance"
    "fade_power" "falloff" "falloff_angle" "fclose" "file" "filter" "finish" "fisheye" "flatness"
    "flip" "focal_point" "fog" "fog_alt" "fog_offset" "fog_type" "fopen" "for" "form" "frequency"
    "fresnel" "function" "gamma" "gather" "gif" "global" "global_lights" "global_settings"
    "gradient" "granite" "gray" "gray_threshold" "green" "grey" "grey_threshold" "hdr"
    "height_field" "hexagon" "hf_gray_16" "hf_grey_16" "hierarchy" "hollow" "hypercomplex" "if"
    "ifdef" "iff" "ifndef" "image_map" "image_pattern" "importance" "include" "inside_vector"
    "interior" "interior_texture" "internal" "interpolate" "intersection" "intervals" "inverse"
    "ior" "irid" "irid_wavelength" "isosurface" "jitter" "jpeg" "julia" "julia_fractal" "lambda"
    "lathe" "lemon" "leopard" "light_group" "light_source" "linear_spline" "linear_sweep"
    "load_file" "local" "location" "look_at" "looks_like" "low_error_factor" "macro" "magnet"
    "major_radius" "mandel" "map_type" "marble" "material" "material_map" "matrix" "max_gradient"
    "max_intersections" "max_iteration" "max_sample" "max_trace" "max_trace_level" "maximum_reuse"
    "media" "media_attenuation" "media_interaction" "merge" "mesh" "mesh2" "mesh_camera" "metallic"
    "method" "metric" "minimum_reuse" "mixed" "mm_per_unit" "mortar" "natural_spline"
    "nearest_count" "no_bump_scale" "no_image" "no_radiosity" "no_reflection" "no_shadow"
    "noise_generator" "normal" "normal_indices" "normal_map" "normal_vectors" "number_of_sides"
    "number_of_tiles" "number_of_waves" "obj" "object" "octaves" "offset" "omega" "omnimax" "once"
    "onion" "open" "optional" "orient" "orientation" "orthographic" "ovus" "panoramic" "parallel"
    "parametric" "pass_through" "pattern" "pavement" "perspective" "pgm" "phase" "phong"
    "phong_size" "photons" "pigment" "pigment_map" "pigment_pattern" "planar" "plane" "png"
    "point_at" "polarity" "poly" "poly_wave" "polygon" "polynomial" "pot" "potential" "ppm"
    "precision" "precompute" "prefix" "premultiplied" "pretrace_end" "pretrace_start" "prism"
    "projected_through" "pwr" "quadratic_spline" "quadric" "quartic" "quaternion" "quick_color"
    "quick_colour" "quilted" "radial" "radiosity" "radius" "rainbow" "ramp_wave" "range" "ratio"
    "read" "reciprocal" "recursion_limit" "red" "reflection" "reflection_exponent" "refraction"
    "render" "repeat" "rgb" "rgbf" "rgbft" "rgbt" "right" "ripples" "rotate" "roughness" "samples"
    "save_file" "sblue" "scale" "scallop_wave" "scattering" "sgreen" "shadowless" "sine_wave"
    "sint16be" "sint16le" "sint32be" "sint32le" "sint8" "size" "sky" "sky_sphere" "slice" "slope"
    "slope_map" "smooth" "smooth_triangle" "solid" "sor" "spacing" "specular" "sphere"
    "sphere_sweep" "spherical" "spiral1" "spiral2" "spline" "split_union" "spotlight" "spotted"
    "sqr" "square" "sred" "srgb" "srgbf" "srgbft" "srgbt" "statistics" "steps" "strength" "sturm"
    "subsurface" "suffix" "superellipsoid" "switch" "sys" "target" "text" "texture" "texture_list"
    "texture_map" "tga" "thickness" "threshold" "tiff" "tightness" "tile2" "tiles" "tiling"
    "tolerance" "toroidal" "torus" "transform" "translate" "translucency" "transmit" "triangle"
    "triangle_wave" "triangular" "ttf" "turb_depth" "turbulence" "type" "u" "u_steps" "uint16be"
    "uint16le" "uint8" "ultra_wide_angle" "undef" "union" "up" "use_alpha" "use_color" "use_colour"
    "use_index" "user_defined" "utf8" "uv_indices" "uv_mapping" "uv_vectors" "v" "v_steps"
    "variance" "vertex_vectors" "warning" "warp" "water_level" "waves" "while" "whittle_cool_warm"
    "whittle_directional" "whittle_gloss" "whittle_ink" "whittle_polished" "whittle_schlick" "width"
    "wood" "wrinkles" "write" "xyz"))
;; end of words

(defgroup pov-scene nil "Scenes of POV-Ray's language." :group 'languages)

(defcustom pov-scene-server '("whittle" "lsp")
  "The language server and its options."
  :type '(repeat string))

(defcustom pov-scene-indent 2
  "Columns of a level."
  :type 'integer)

(defvar pov-scene-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?/ ". 124n" table)
    (modify-syntax-entry ?* ". 23n" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?# "." table)
    table))

(defconst pov-scene-font-lock
  `((,(concat "#[ \t]*" (regexp-opt pov-scene-directives) "\\>") . font-lock-preprocessor-face)
    ("#[ \t]*\\(?:declare\\|local\\)[ \t]+\\(\\w+\\)" 1 font-lock-variable-name-face)
    ("#[ \t]*macro[ \t]+\\(\\w+\\)" 1 font-lock-function-name-face)
    (,(regexp-opt pov-scene-functions 'words) . font-lock-builtin-face)
    (,(regexp-opt pov-scene-words 'words) . font-lock-keyword-face)))

(defconst pov-scene-opens "#[ \t]*\\(?:if\\|ifdef\\|ifndef\\|while\\|for\\|switch\\|macro\\)\\>")
(defconst pov-scene-branches "[ \t]*#[ \t]*\\(?:else\\|elseif\\|case\\|range\\)\\>")
(defconst pov-scene-ends "[ \t]*#[ \t]*end\\>")

(defun pov-scene--level ()
  "How many directives are open at the start of this line."
  (save-excursion
    (let ((place (line-beginning-position)) (level 0))
      (goto-char (point-min))
      (while (re-search-forward "#[ \t]*\\(\\w+\\)" place t)
        (unless (nth 8 (save-excursion (syntax-ppss (match-beginning 0))))
          (cond ((string= (match-string 1) "end") (setq level (max 0 (1- level))))
                ((save-excursion (goto-char (match-beginning 0)) (looking-at pov-scene-opens))
                 (setq level (1+ level))))))
      level)))

(defun pov-scene-indent-line ()
  "Indents a line by the braces and directives that are open."
  (interactive)
  (let* ((state (save-excursion (syntax-ppss (line-beginning-position))))
         (level (+ (car state) (pov-scene--level))))
    (unless (nth 8 state)
      (save-excursion
        (back-to-indentation)
        (when (looking-at "[])}]") (setq level (1- level)))
        (beginning-of-line)
        (when (or (looking-at pov-scene-branches) (looking-at pov-scene-ends)) (setq level (1- level)))
        (indent-line-to (* pov-scene-indent (max 0 level))))
      (when (< (current-column) (current-indentation)) (back-to-indentation)))))

;;;###autoload
(define-derived-mode pov-scene-mode prog-mode "Scene"
  "Scenes of POV-Ray's language."
  (setq-local comment-start "// "
              comment-end ""
              comment-start-skip "//+[ \t]*\\|/\\*+[ \t]*"
              indent-line-function #'pov-scene-indent-line
              indent-tabs-mode nil
              tab-width pov-scene-indent
              font-lock-defaults '(pov-scene-font-lock)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.pov\\'" . pov-scene-mode))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs (cons 'pov-scene-mode (lambda (&rest _) pov-scene-server))))

(provide 'pov-scene-mode)
;;; pov-scene-mode.el ends here
