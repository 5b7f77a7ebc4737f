// SPDX-License-Identifier: Apache-2.0
// NOT RUN: no editor was at hand.
// Draws a sensor's surface: the vertex of each pixel goes where that pixel's reading is. Needs neither compute nor geometry
// shaders. Triangles over a depth step or a missing reading are cut away: `edge` is 0 only where all neighbours agree.
Shader "roomcast/Depth Mesh"
{
    Properties
    {
        _Depth ("Depth, millimetres / 65535", 2D) = "black" {}
        _Color ("Colour", 2D) = "white" {}
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Cull Off
        Pass
        {
            CGPROGRAM
            #pragma target 3.0
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"

            sampler2D _Depth, _Color;
            float4 _Size, _Intrinsics, _Distortion;
            float _K3;
            float4x4 _RoomFromDepth;

            struct Varyings
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
                float edge : TEXCOORD1;
            };

            float MetresAt(float2 pixel)
            {
                float2 uv = (clamp(pixel, 0, _Size.xy - 1) + 0.5) / _Size.xy;
                return tex2Dlod(_Depth, float4(uv, 0, 0)).r * 65.535;
            }

            // The ray of a pixel at depth 1: the inverse of Brown and Conrady's distortion, by fixed-point steps.
            float2 Ray(float2 pixel)
            {
                float2 distorted = (pixel - _Intrinsics.zw) / _Intrinsics.xy, ray = distorted;
                for (int i = 0; i < 5; ++i)
                {
                    float r2 = dot(ray, ray);
                    float radial = 1 + r2 * (_Distortion.x + r2 * (_Distortion.y + r2 * _K3));
                    float2 tangential = float2(
                        2 * _Distortion.z * ray.x * ray.y + _Distortion.w * (r2 + 2 * ray.x * ray.x),
                        _Distortion.z * (r2 + 2 * ray.y * ray.y) + 2 * _Distortion.w * ray.x * ray.y);
                    ray = (distorted - tangential) / radial;
                }
                return ray;
            }

            Varyings vert(float4 vertex : POSITION)
            {
                float2 pixel = vertex.xy;
                float z = MetresAt(pixel);
                float allowed = 0.01 + 0.02 * z; // as roomcast's exports
                float edge = z > 0 ? 0 : 1;
                for (int i = 0; i < 4; ++i)
                {
                    float2 step = i < 2 ? float2(i * 2 - 1, 0) : float2(0, (i - 2) * 2 - 1);
                    edge = max(edge, abs(MetresAt(pixel + step) - z) > allowed ? 1 : 0);
                }
                float3 inDepth = float3(Ray(pixel), 1) * z;
                Varyings o;
                o.position = UnityObjectToClipPos(mul(_RoomFromDepth, float4(inDepth, 1)));
                o.uv = (pixel + 0.5) / _Size.xy;
                o.edge = edge;
                return o;
            }

            fixed4 frag(Varyings i) : SV_Target
            {
                clip(0.5 - i.edge);
                return fixed4(tex2D(_Color, i.uv).rgb, 1);
            }
            ENDCG
        }
    }
}
